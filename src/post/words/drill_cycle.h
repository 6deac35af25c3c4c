// Finds the moves of a drilled hole for which a control has one word.
#pragma once

#include <optional>
#include <span>

#include "model/move.h"
#include "model/options/post_options.h"
#include "model/part.h"
#include "post/words/iso_dialect.h"
#include "post/words/print_grid.h"

namespace clearcut::post {

/// mm; height above the last depth at which a peck begins to feed again, as in LinuxCNC.
inline constexpr double kPeckGap = 0.254;

enum class DrillForm {
  kAtOnce,   ///< G81
  kPecks,    ///< G83: up out of the hole after each peck
  kChips,    ///< G73: up a little after each peck
  kFeedsOut  ///< G85: out at the feed; of a tap G84, with the spindle turning back
};

/// A hole made by a cycle. Printed heights.
struct DrillBlock {
  DrillForm form = DrillForm::kAtOnce;
  Ticks bottom;
  long long clear = 0;  ///< height at which feeding begins (R word)
  long long above = 0;  ///< height before and after
  long long peck = 0;   ///< Q word; 0: in one go
  MmPerMin feed;
  std::size_t moves = 0;  ///< number of moves it replaces
};

/// The hole at the beginning of `moves`: down at the rapid, down at the feed (with retracts to the start of the feed
/// or by the gap, in equal pecks), and back up at the rapid, or first at the feed, to the start height.
std::optional<DrillBlock> drill_block(std::span<const Move> moves, const PrintGrid& grid);

/// The tap used in a section; null for other tools.
const Tool* tap_of(const Section& section, const Part& part);

/// "G81", "G83", "G73", "G85"; of a tap "G84", "G74" for left-hand ones, "G33.1" if the control synchronises taps
/// this way.
std::string_view cycle_word(const DrillBlock& hole, const Tool* tap, const IsoDialect& dialect);

/// Throws InputError if the control cannot use this tap: it needs a floating holder.
void refuse_tap(const Tool& tap, Tapping tapping, std::string_view control);

}  // namespace clearcut::post
