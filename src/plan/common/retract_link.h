// How long a retract link takes, for comparing it with a link at depth. Used by the planner alone.
#pragma once

#include <optional>
#include <span>

#include "base/units.h"
#include "geometry/route/legal_route.h"
#include "model/layer.h"
#include "model/machine.h"

namespace clearcut::plan {

/// The heights of a retract link. mm.
struct RetractHeights {
  double lift = 0;    ///< from the tip up to where rapids cross
  double plunge = 0;  ///< the last part of the descent, at the plunge feed
};

/// Of a layer that is left for the clearance over all that stands.
RetractHeights retract_heights(const Layer& layer);

/// Lifting, crossing and coming down again, as the linker is likely to do it.
class RetractLink {
 public:
  RetractLink(const Machine& machine, MmPerMin feed, const RetractHeights& heights)
      : machine_(machine), feed_(feed), heights_(heights) {}

  /// Seconds to a place `across` mm away.
  double time(double across) const;

  /// Seconds along all paths, each with a retract to a place `across` mm away.
  double time_of(std::span<const Path> paths, double across) const;

  /// A legal path from a to b at depth, where there is one that is quicker than a retract.
  std::optional<Path> link_at_depth(Vec2 a, Vec2 b, const LegalRoutes& routes) const;

 private:
  double rapid_time(double length) const;

  const Machine& machine_;
  MmPerMin feed_;
  RetractHeights heights_;
};

}  // namespace clearcut::plan
