// Joins lines in space into one section: rapids over the part, straight down, along, and out again.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "link/link.h"

namespace clearcut::link {

/// Where the tip may go straight from one track to the next, mm.
struct TipRoom {
  /// Whether a straight way at height z lies inside what is carved in the end. Empty: nowhere.
  std::function<bool(Vec2 from, Vec2 to, double z)> holds;
  /// Ways at this height or above take no more at once than one pass may, whatever they lead through.
  double high = -std::numeric_limits<double>::infinity();
  /// Lower ways are no longer than this: the cone has cut all but as much at their beginning.
  double longest_below = std::numeric_limits<double>::infinity();
};

/// Each set of tracks is run before the next. Within a set the track whose beginning is nearest comes next; open tracks may
/// begin at either end. `clear_z`: mm, the height above all material to which rapids come down. Where a track descends the
/// feed is reduced, so that the tip never goes down faster than the plunge feed. Where `room` allows it and it takes no longer
/// than lifting, the tip goes to the next track at the height of the shallower end, or higher where that would cut too much. Cost O(tracks^2).
Section link_tracks(std::vector<std::vector<Track>> sets, double clear_z, const LinkOptions& options,
                    const TipRoom& room = {});

}  // namespace clearcut::link
