// Contours of polyclipping that touch themselves, split into loops that do not.
#pragma once

#include <polyclipping/clipper.hpp>
#include <vector>

namespace clearcut::inline geometry {

struct SplitContour {
  ClipperLib::Path contour;  ///< counter-clockwise
  ClipperLib::Paths holes;   ///< clockwise
};

/// Splits every contour where it comes back to one of its points, and nests what comes of it anew: half of a ring that touches
/// itself is its hole. Contours must not cross. Cost O(n + k l), n points, k holes, l contours, and k n where boxes nest.
std::vector<SplitContour> split_contours(const ClipperLib::PolyTree& tree);

}  // namespace clearcut::inline geometry
