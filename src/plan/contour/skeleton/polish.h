// Removes corners from shortened paths.
#pragma once

#include "plan/contour/skeleton/bands.h"
#include "plan/contour/skeleton/tighten.h"

namespace clearcut::plan::contour {

/// Drops every vertex of the paths that is not needed for clearing the same area: fewer corners, shorter paths. Every
/// point within `radius` mm of a path or ring stays so.
/// Cost  O(vertices * (edges near)^2).
void drop_needless_vertices(Bands& paths, const TightenJob& job, double radius);

}  // namespace clearcut::plan::contour
