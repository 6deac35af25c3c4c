#include "post/drill_cycle.h"

#include <algorithm>
#include <cmath>

namespace clearcut::post {
namespace {

constexpr double kPeckGap = 0.254;  // mm; LinuxCNC feeds again this far above the last depth
constexpr double kSlack = 1e-6;     // mm

bool rapid_up(const Move& move) {
  return is_rapid(move.kind) && move.is_vertical() && move.z_to > move.z_from;
}

bool rapid_down(const Move& move) {
  return is_rapid(move.kind) && move.is_vertical() && move.z_to < move.z_from;
}

bool feed_down(const Move& move) {
  return !is_rapid(move.kind) && move.is_vertical() && move.z_to < move.z_from;
}

bool near(double a, double b) {
  return std::abs(a - b) < kSlack;
}

/// Whether moves 2.. go on with the peck number `peck` as a cycle does: up, down to the gap, on.
bool pecks_again(std::span<const Move> moves, double clear, double step, int peck) {
  if (moves.size() < 4) return false;
  const double depth = clear - peck * step;
  return near(moves[0].z_to, depth) && rapid_up(moves[1]) && near(moves[1].z_to, clear) &&
         rapid_down(moves[2]) && near(moves[2].z_to, std::min(clear, depth + kPeckGap)) &&
         feed_down(moves[3]) && moves[3].z_to >= depth - step - kSlack && moves[3].feed == moves[0].feed;
}

}  // namespace

std::optional<DrillBlock> drill_block(std::span<const Move> moves, const PrintGrid& grid) {
  if (moves.size() < 3 || !rapid_down(moves[0]) || !feed_down(moves[1])) return std::nullopt;
  const double above = moves[0].z_from, clear = moves[0].z_to, step = clear - moves[1].z_to;
  std::size_t last = 1;
  int pecks = 1;
  while (pecks_again(moves.subspan(last), clear, step, pecks)) {
    last += 3;
    ++pecks;
  }
  const bool out = last + 1 < moves.size() && rapid_up(moves[last + 1]) && near(moves[last + 1].z_to, above);
  if (!out) return std::nullopt;
  DrillBlock block;
  block.bottom = grid.ticks(moves[last].path.to, moves[last].z_to);
  block.clear = grid.ticks(clear);
  block.above = grid.ticks(above);
  block.peck = pecks > 1 ? std::max(1LL, grid.ticks(step)) : 0;
  block.feed = moves[1].feed;
  block.moves = last + 2;
  return block;
}

}  // namespace clearcut::post
