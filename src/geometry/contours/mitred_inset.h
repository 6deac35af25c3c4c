// Insets of polygons whose reflex corners stay sharp.
#pragma once

#include "base/tolerances.h"
#include "geometry/region.h"

namespace clearcut::inline geometry {

/// The region bounded by the sides of `region`, each moved inwards by `distance` mm and prolonged to the
/// intersections with its neighbours, at reflex corners, too (mitred). At reflex corners the result is farther from
/// the boundary than an inset with round corners. The region has no arcs.
///
/// Shape   as many regions as the sides enclose; sides vanish and regions split.
/// Error   1 nm, the grid of polyclipping, which computes the result; corners sharper than 0.1 degrees are cut off.
/// Cost    O((n + k) log n), n sides, k crossings of moved sides.
Regions mitred_inset(const Region& region, double distance, const Tolerances& tol);

/// Whether some side of the region is an arc.
bool has_arcs(const Region& region);
/// Whether there is a reflex corner: the boundary turns to the right there, by more than rounding does.
bool has_reflex_corner(const Region& region);

}  // namespace clearcut::inline geometry
