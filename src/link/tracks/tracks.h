// Joins lines in space into one section: rapids over the part, straight down, along, and out again.
#pragma once

#include <vector>

#include "link/link.h"

namespace clearcut::link {

/// Each set of tracks is run before the next. Within a set the track whose beginning is nearest comes next; open tracks may
/// begin at either end. `clear_z`: mm, the height above all material to which rapids come down. Where a track descends the
/// feed is reduced, so that the tip never goes down faster than the plunge feed. Cost O(tracks^2).
Section link_tracks(std::vector<std::vector<Track>> sets, double clear_z, const LinkOptions& options);

}  // namespace clearcut::link
