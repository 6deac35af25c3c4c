// Adaptive clearing, with limited engagement: a spiral in the widest place, then cuts from wall to wall at the limit;
// and its entry in the table of strategies.
#pragma once

#include <optional>
#include <stop_token>

#include "base/debug_sink.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "model/layer.h"
#include "model/options/strategy_entry.h"
#include "plan/common/machine_clock.h"

namespace clearcut::plan::adaptive {

struct AdaptiveOptions {
  /// Largest engagement after the entry.
  Radians engagement = Radians::of_degrees(60);
  /// Share of that limit, or of a lower one that holds beside open sides, at which cuts aim.
  double limit_share = 1;
  /// The first entry is at this point, in the connected area that holds it. If absent, or nearer to a wall
  /// than an entry needs: in a predrilled hole, else in the widest place.
  std::optional<Vec2> start;
  /// mm; greatest diameter of the centre's circle on the helix of an entry.
  std::optional<double> widest_helix;
  /// Joints of cuts are eased and links rounded where that saves the machine time. If it does not run: neither.
  MachineClock clock;
  /// Asked before each cut; plan_adaptive throws Cancelled if a stop was requested.
  std::stop_token cancel;
  /// Takes a picture after each step; null: none.
  DebugSink* pictures = nullptr;
};

/// Plans the passes of one layer with limited engagement.
///
/// Shape   Open passes with their links, to be run in this order. For each wide entry region of each
///         connected legal area a spiral, then cuts from wall to wall with the engagement at the limit, at
///         last cuts along the walls at tool_radius + wall_stock. Empty where the cutter fits nowhere.
/// Error   The engagement exceeds the limit on the circle of an entry, and where finishing finds no cut within
///         it: such stretches of wall and rests are cut straight. Elsewhere by kExcess, rare peaks aside.
/// Cost    O(length of the passes / radius * passes nearby); about 3 us for a step of a tenth of the radius.
/// Source  Own; how the spiral widens and how a steady cut runs follow from the engagement in closed form,
///         see docs/adaptive.md.
LayerPasses plan_adaptive(const Layer& layer, const AdaptiveOptions& options, const Tolerances& tol);

/// `clock_of`: how long moves take on the machine that a workingstep is for.
StrategyEntry entry(ClockOf clock_of);

}  // namespace clearcut::plan::adaptive
