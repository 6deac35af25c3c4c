// Time of a retract link, for comparison with a link at depth.
#pragma once

#include <optional>
#include <span>

#include "base/units.h"
#include "geometry/route/legal_route.h"
#include "model/layer.h"
#include "model/machine.h"

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

}  // namespace clearcut::plan
