// Contours of polyclipping, each with its holes.
#pragma once

#include <polyclipping/clipper.hpp>
#include <vector>

namespace clearcut::inline geometry {

struct NestedContour {
  ClipperLib::Path contour;  ///< counter-clockwise
  ClipperLib::Paths holes;   ///< clockwise
};

/// Nests contours that touch neither themselves nor cross each other: those in an even number of others have as holes what lies in
/// them and in nothing between. What lies in the holes comes before the contour about it. Cost as of ContourIndex for each.
std::vector<NestedContour> nested_contours(const ClipperLib::Paths& contours);

/// Splits every contour where it comes back to one of its points, and nests what comes of it anew: half of a ring that touches
/// itself is its hole. Contours must not cross. Cost as of ContourIndex for each.
std::vector<NestedContour> split_contours(const ClipperLib::Paths& contours);

}  // namespace clearcut::inline geometry
