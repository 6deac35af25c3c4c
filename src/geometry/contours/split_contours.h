// Contours of polyclipping, each with its holes.
#pragma once

#include <polyclipping/clipper.hpp>
#include <vector>

namespace clearcut::inline geometry {

struct NestedContour {
  ClipperLib::Path contour;  ///< counter-clockwise
  ClipperLib::Paths holes;   ///< clockwise
};

/// Nests contours that neither touch themselves nor cross each other: a contour inside an even number of others is an
/// outer one, and its holes are the contours directly inside it. Contours inside the holes come before the contour
/// around them. Cost as of ContourIndex for each.
std::vector<NestedContour> nested_contours(const ClipperLib::Paths& contours);

/// Splits every contour at points that it passes twice, and nests the resulting contours anew: a ring that touches
/// itself becomes an outer contour and its hole. Contours must not cross. Cost as of ContourIndex for each.
std::vector<NestedContour> split_contours(const ClipperLib::Paths& contours);

}  // namespace clearcut::inline geometry
