// How long paths of one depth, and retracts beside links at depth, take on the machine that a program is for, by the
// planner of its control.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "base/units.h"
#include "geometry/edge.h"
#include "geometry/route/legal_paths.h"
#include "model/control.h"
#include "model/layer.h"
#include "model/machine.h"
#include "model/move.h"
#include "model/options/strategy_entry.h"

namespace clearcut::plan {

/// The heights of a retract link, mm.
struct RetractHeights {
  double lift = 0;    ///< from the depth of the tip up to the height of rapid moves
  double plunge = 0;  ///< the last part of the descent, at the plunge feed
};

/// The heights from `layer` up to its clearance height.
RetractHeights retract_heights(const Layer& layer);

/// The time of a retract link: up, across by rapid moves, and down again.
class RetractLink {
 public:
  RetractLink(const Machine& machine, MmPerMin feed, const RetractHeights& heights)
      : machine_(machine), feed_(feed), heights_(heights) {}

  /// Seconds of a retract link to a place `across` mm away.
  double time(double across) const;

  /// Seconds to cut all of `paths`, each followed by a retract link to a place `across` mm away.
  double time_of(std::span<const Path> paths, double across) const;

  /// A legal path from a to b at depth; nothing if there is none or if a retract link is quicker.
  std::optional<Path> link_at_depth(Vec2 a, Vec2 b, const LegalRoutes& routes) const;

 private:
  double rapid_time(double length) const;

  const Machine& machine_;
  MmPerMin feed_;
  RetractHeights heights_;
};

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
