// The area that a disc reaches in a region, without the outline of this area.
#pragma once

#include "geometry/region.h"

namespace clearcut::inline geometry {

/// mm2; upper bound of the area within `d` mm of the regions (Steiner): A + d L + pi d2 (pieces - islands) for their area A and
/// the length L of their boundary. Exact if no two stretches of the boundary reach the same place. O(edges).
double area_within(const Regions& regions, double d);

/// Whether area_within(inset, d) is exactly the area that a disc of radius `d` reaches in `region`, `inset` being all places of the region
/// at least `d` from its boundary. It is if the inset is one piece with the region's number of islands: then what lies beside it are
/// corners, each beside one place of the inset. Necks narrower than the disc, whose two ends may reach the same place, would part the
/// inset or join islands with other boundaries.
bool is_opened_at_corners_only(const Region& region, const Regions& inset);

}  // namespace clearcut::inline geometry
