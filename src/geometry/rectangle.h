// Rectangles along the axes as loops and regions.
#pragma once

#include "geometry/box.h"
#include "geometry/region.h"

namespace clearcut::inline geometry {

/// The outline of a box that is not empty, counter-clockwise from its lowest corner.
Loop rectangle(const Box& box);

/// All of a box whose sides are longer than 0.
Region rectangular_region(const Box& box);

/// The frame around a box, `width` (mm, > 0) wide on all sides.
Region frame_around(const Box& box, double width);

}  // namespace clearcut::inline geometry
