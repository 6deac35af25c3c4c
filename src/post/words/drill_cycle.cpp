#include "post/words/drill_cycle.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/tolerances.h"

namespace clearcut::post {
namespace {

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
  return std::abs(a - b) < kSamePlaceMm;
}

/// Whether moves 2.. go on with the peck number `peck` as a cycle does: up, down to the gap, on.
bool pecks_again(std::span<const Move> moves, double clear, double step, int peck) {
  if (moves.size() < 4) return false;
  const double depth = clear - peck * step;
  return near(moves[0].z_to, depth) && rapid_up(moves[1]) && near(moves[1].z_to, clear) &&
         rapid_down(moves[2]) && near(moves[2].z_to, std::min(clear, depth + kPeckGap)) &&
         feed_down(moves[3]) && moves[3].z_to >= depth - step - kSamePlaceMm &&
         moves[3].feed == moves[0].feed;
}

bool breaks_chip_again(std::span<const Move> moves, double clear, double step, int peck) {
  if (moves.size() < 3) return false;
  const double depth = clear - peck * step;
  return near(moves[0].z_to, depth) && rapid_up(moves[1]) &&
         near(moves[1].z_to, std::min(clear, depth + kPeckGap)) && feed_down(moves[2]) &&
         moves[2].z_to >= depth - step - kSamePlaceMm && moves[2].feed == moves[0].feed;
}

bool feed_up(const Move& move) {
  return !is_rapid(move.kind) && move.is_vertical() && move.z_to > move.z_from;
}

/// Number of the last move down, and the pecks.
struct Descent {
  DrillForm form = DrillForm::kAtOnce;
  std::size_t last = 1;
};

Descent descent_of(std::span<const Move> moves, double clear, double step) {
  Descent found;
  int pecks = 1;
  for (; pecks_again(moves.subspan(found.last), clear, step, pecks); ++pecks) {
    found.form = DrillForm::kPecks;
    found.last += 3;
  }
  if (found.form == DrillForm::kPecks) return found;
  for (; breaks_chip_again(moves.subspan(found.last), clear, step, pecks); ++pecks) {
    found.form = DrillForm::kChips;
    found.last += 2;
  }
  return found;
}

}  // namespace

std::optional<DrillBlock> drill_block(std::span<const Move> moves, const PrintGrid& grid) {
  if (moves.size() < 3 || !rapid_down(moves[0]) || !feed_down(moves[1])) return std::nullopt;
  const double above = moves[0].z_from, clear = moves[0].z_to, step = clear - moves[1].z_to;
  auto [form, last] = descent_of(moves, clear, step);
  DrillBlock block;
  block.bottom = grid.ticks(moves[last].path.to, moves[last].z_to);
  const bool feeds_out = form == DrillForm::kAtOnce && last + 1 < moves.size() && feed_up(moves[last + 1]) &&
                         near(moves[last + 1].z_to, clear) && moves[last + 1].feed == moves[last].feed;
  if (feeds_out) form = DrillForm::kFeedsOut, ++last;
  const bool out = last + 1 < moves.size() && rapid_up(moves[last + 1]) && near(moves[last + 1].z_to, above);
  if (!out) return std::nullopt;
  block.form = form;
  block.clear = grid.ticks(clear);
  block.above = grid.ticks(above);
  const bool pecked = form == DrillForm::kPecks || form == DrillForm::kChips;
  block.peck = pecked ? std::max(1LL, grid.ticks(step)) : 0;
  block.feed = moves[1].feed;
  block.moves = last + 2;
  return block;
}

const Tool* tap_of(const Section& section, const Part& part) {
  const Tool* const tool = tool_numbered(part.tools, section.tool_number);
  return tool && tool->kind == ToolKind::kTap ? tool : nullptr;
}

std::string_view cycle_word(const DrillBlock& hole, const Tool* tap, const IsoDialect& dialect) {
  if (tap && !tap->floating && dialect.tapping == Tapping::kRigidByG33_1) return "G33.1";
  if (tap) return tap->left_hand ? "G74" : "G84";
  if (hole.form == DrillForm::kPecks) return "G83";
  if (hole.form == DrillForm::kChips) return "G73";
  return hole.form == DrillForm::kFeedsOut ? "G85" : "G81";
}

void refuse_tap(const Tool& tap, Tapping tapping, std::string_view control) {
  if (tap.floating || tapping == Tapping::kRigid || tapping == Tapping::kRigidByM29 ||
      tapping == Tapping::kRigidByG33_1)
    return;
  throw InputError(
      "--post " + std::string(control),
      "the control cannot tie the feed to the spindle, so T" + std::to_string(tap.number) +
          " needs a holder that floats: say so (--tool tap:" + (tap.name.empty() ? "..." : tap.name) +
          ":floating), or mill the threads (a layer THREAD_..., and a threadmill)");
}

}  // namespace clearcut::post
