// The feed of descending moves.
#pragma once

#include <algorithm>

#include "base/elementary.h"
#include "base/units.h"

namespace clearcut::link {

/// The feed, reduced so that the tip descends no faster than at `plunge_feed` on a move `along` mm long in plan and
/// `down` mm deep. A written coordinate is rounded by at most half of 0.0001 inch; this may make a short piece
/// steeper.
inline MmPerMin sinking_feed(MmPerMin feed, MmPerMin plunge_feed, double along, double down) {
  constexpr double kRounded = 0.0013;  // mm
  if (down <= 0) return feed;
  const double deeper = down + 2 * kRounded, shorter = std::max(0.0, along - 3 * kRounded);
  const double share = deeper / base::hypot(shorter, deeper);
  return std::min(feed, plunge_feed * (1 / share));
}

}  // namespace clearcut::link
