// Rectangles along the axes as loops and regions.
#pragma once

#include "geometry/box.h"
#include "geometry/region.h"

namespace clearcut::inline geometry {

/// The outline of a box that is not empty, counter-clockwise from its lowest corner.
Loop rectangle(const Box& box);

/// All of a box whose sides are longer than 0.
Region rectangular_region(const Box& box);

/// What surrounds a box on all sides, as wide as `width` (mm, > 0).
Region frame_around(const Box& box, double width);

}  // namespace clearcut::inline geometry
