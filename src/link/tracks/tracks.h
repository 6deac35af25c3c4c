// Joins lines in space into one section: rapids over the part, straight down, along, and out again.
#pragma once

#include <vector>

#include "link/link.h"

namespace clearcut::link {

/// Every set of tracks is run before the next; within a set always the nearest beginning comes next, so that lines are run
/// either way round. `clear_z`: how far down rapids may come, over all that stands. Feeds are slowed where the way
/// falls, so that the tip never goes down faster than the plunge feed. Cost O(tracks^2).
Section link_tracks(std::vector<std::vector<Track>> sets, double clear_z, const LinkOptions& options);

}  // namespace clearcut::link
