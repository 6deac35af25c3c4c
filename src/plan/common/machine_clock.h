// How long paths of one depth take on the machine that a program is for, by the planner of its control.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "base/units.h"
#include "geometry/edge.h"
#include "model/control.h"
#include "model/machine.h"
#include "model/move.h"
#include "model/options/strategy_entry.h"

namespace clearcut::plan {

/// Share of the acceleration that controls use across an arc.
inline constexpr double kAcrossArcs = 0.866;

/// Without a feed it does not run: nothing is known of the machine.
struct MachineClock {
  Machine machine;
  MmPerMin feed;
  MmPerMin link_feed;  ///< through what is cleared
  PathControl path;    ///< how far the control may leave the path
  std::optional<MotionPlanner> of_control;

  bool runs() const { return feed.mm_per_min() > 0 && machine.acceleration > 0; }
  /// Seconds from rest to rest. `kinds`: of each edge, kCut or kLink; empty: all are cut.
  double seconds(std::span<const Edge> edges, std::span<const MoveKind> kinds) const;
  /// mm; the least radius at which an arc is run at `speed` mm/s.
  double radius_at(double speed) const;
  /// mm within which the machine gathers the feed's speed from rest.
  double run_up() const;
};

/// The clock of a workingstep, from whoever knows the control that the program is for.
using ClockOf = std::function<MachineClock(const StrategyRequest&)>;

}  // namespace clearcut::plan
