// Joins lines in space into one section: rapids over the part, straight down, along, and out again.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "link/link.h"

namespace clearcut::link {

/// Room for straight moves of the tip from one track to the next, mm.
struct TipRoom {
  /// Whether a straight move at height z is inside the finished carving. Empty: never.
  std::function<bool(Vec2 from, Vec2 to, double z)> holds;
  /// Moves at this height or above remove no more than the permitted depth of one pass, regardless of the material in
  /// their path.
  double high = -std::numeric_limits<double>::infinity();
  /// Greatest length of lower moves: the cone has already cut all but this much at their beginning.
  double longest_below = std::numeric_limits<double>::infinity();
};

/// Each set of tracks is run before the next. Within a set the track with the nearest beginning comes next; open
/// tracks may begin at either end. `clear_z`: mm, the height above all material to which rapids descend. On
/// descending tracks the feed is reduced, so that the tip never descends faster than the plunge feed. If `room`
/// allows a direct move and this is no slower than a retract, the tip moves to the next track at the height of the
/// shallower end, or higher if that move would cut too much. Cost O(tracks^2).
Section link_tracks(std::vector<std::vector<Track>> sets, double clear_z, const LinkOptions& options,
                    const TipRoom& room = {});

}  // namespace clearcut::link
