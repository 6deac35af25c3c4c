// Joins lines in space into one section: rapids over the part, straight down, along, and out again.
#pragma once

#include <functional>
#include <vector>

#include "link/link.h"

namespace clearcut::link {

/// Whether the tip may go straight from one place to another at height z: inside what is carved in the end. Empty: nowhere.
using TipRoom = std::function<bool(Vec2 from, Vec2 to, double z)>;

/// Each set of tracks is run before the next. Within a set the track whose beginning is nearest comes next; open tracks may
/// begin at either end. `clear_z`: mm, the height above all material to which rapids come down. Where a track descends the
/// feed is reduced, so that the tip never goes down faster than the plunge feed. Where `room` allows it and it takes no longer
/// than lifting, the tip goes to the next track at the height of the shallower end. Cost O(tracks^2).
Section link_tracks(std::vector<std::vector<Track>> sets, double clear_z, const LinkOptions& options,
                    const TipRoom& room = {});

}  // namespace clearcut::link
