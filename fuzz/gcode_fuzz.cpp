// Any bytes: read_gcode returns a sound toolpath or throws InputError; what it returns can be posted in every
// dialect and read again.
#include <cmath>
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "post/post.h"
#include "read/gcode/gcode.h"

namespace {

using namespace clearcut;

void require_sound(const Toolpath& toolpath) {
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
bool is_small(const Toolpath& toolpath) {
  std::size_t moves = 0;
  for (const Section& section : toolpath.sections) {
    moves += section.moves.size();
    for (const Move& move : section.moves) {
      if (move.path.is_arc() && move.path.radius() > 1000) return false;
    }
  }
  return moves < 1000;
}

void post_and_read_again(const Toolpath& toolpath, std::size_t choice) {
  PostOptions options;
  options.dialect = post_dialects()[choice % post_dialects().size()];
  options.inch = choice % 3 == 0;
  std::string text;
  try {
    text = post(toolpath, Part{}, options);
  } catch (const InputError&) {
    return;  // a feed move without feed
  }
  require_sound(read_gcode(text, "posted").toolpath);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Toolpath toolpath;
  try {
    toolpath = read_gcode(text, "fuzz").toolpath;
  } catch (const InputError&) {
    return 0;
  }
  require_sound(toolpath);
  if (is_small(toolpath)) post_and_read_again(toolpath, size);
  return 0;
}
