// What must hold of every toolpath that was read, whatever the text.
#pragma once

#include <cmath>

#include "base/error.h"
#include "post/post.h"
#include "read/gcode/gcode.h"

namespace clearcut::fuzz {

inline void require_sound(const Toolpath& toolpath) {
  const Move* before = nullptr;
  for (const Section& section : toolpath.sections) {
    CLEARCUT_ASSERT(!section.moves.empty());
    for (const Move& move : section.moves) {
      CLEARCUT_ASSERT(std::isfinite(move.length()));
      CLEARCUT_ASSERT(std::isfinite(move.feed.mm_per_min()));
      CLEARCUT_ASSERT(!move.is_vertical() || move.z_from != move.z_to);
      CLEARCUT_ASSERT(!before || (before->path.to == move.path.from && before->z_to == move.z_from));
      before = &move;
    }
  }
}

/// Few moves and no arcs over a metre, which posts may draw in very many lines.
inline bool is_small(const Toolpath& toolpath) {
  std::size_t moves = 0;
  for (const Section& section : toolpath.sections) {
    moves += section.moves.size();
    for (const Move& move : section.moves) {
      if (move.path.is_arc() && move.path.radius() > 1000) return false;
    }
  }
  return moves < 1000;
}

inline void post_and_read_again(const Toolpath& toolpath, const PostOptions& options) {
  std::string text;
  try {
    text = post::write_program(toolpath, Part{}, options);
  } catch (const InputError&) {
    return;  // a feed move without feed
  }
  require_sound(read::gcode::read_gcode(text, "posted").toolpath);
}

}  // namespace clearcut::fuzz
