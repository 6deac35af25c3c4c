// Finds the moves of a drilled hole that a control has one word for.
#pragma once

#include <optional>
#include <span>

#include "model/move.h"
#include "model/options/post_options.h"
#include "model/part.h"
#include "post/words/iso_dialect.h"
#include "post/words/print_grid.h"

namespace clearcut::post {

/// mm; so far above the last depth a peck begins to feed again, as LinuxCNC does it.
inline constexpr double kPeckGap = 0.254;

enum class DrillForm {
  kAtOnce,   ///< G81
  kPecks,    ///< G83: up out of the hole after each peck
  kChips,    ///< G73: up a little after each peck
  kFeedsOut  ///< G85: out at the feed; of a tap G84, with the spindle turning back
};

/// A hole as a cycle makes it. Printed heights.
struct DrillBlock {
  DrillForm form = DrillForm::kAtOnce;
  Ticks bottom;
  long long clear = 0;  ///< where feeding begins (R word)
  long long above = 0;  ///< height before and after
  long long peck = 0;   ///< Q word; 0: in one go
  MmPerMin feed;
  std::size_t moves = 0;  ///< how many it stands for
};

/// The hole that `moves` begin with: down at the rapid, down at the feed (with rises to where that began or by the gap, in
/// equal pecks), and back up at the rapid, or first at the feed, to where it came from.
std::optional<DrillBlock> drill_block(std::span<const Move> moves, const PrintGrid& grid);

/// The tap that a section works with; null for other tools.
const Tool* tap_of(const Section& section, const Part& part);

/// "G81", "G83", "G73", "G85"; of a tap "G84", "G74" for left-hand ones, "G33.1" where the control ties it to the spindle so.
std::string_view cycle_word(const DrillBlock& hole, const Tool* tap, const IsoDialect& dialect);

/// Throws InputError where the control cannot turn this tap: it needs a floating holder.
void refuse_tap(const Tool& tap, Tapping tapping, std::string_view control);

}  // namespace clearcut::post
