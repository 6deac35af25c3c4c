// Nesting of the contours of polyclipping: the contour around another one, and contours each with its holes.
#pragma once

#include <cstddef>
#include <optional>
#include <polyclipping/clipper.hpp>
#include <vector>

#include "geometry/spatial/box_tree.h"

namespace clearcut::inline geometry {

/// Units of the grid by which a point may be beside the edge that it is rounded from, as on walls that two contours share.
inline constexpr double kGridRounding = 2;

/// Finds the contours about another one, by a ray from one of its points. Keeps a reference to `contours`, which must
/// outlive the index. Contours must not cross each other; they may touch. A contour directly inside another one has
/// the opposite orientation, as polyclipping returns them: two contours of the same orientation that share an edge
/// are beside each other. Built in O(n) for n points.
class ContourIndex {
 public:
  explicit ContourIndex(const ClipperLib::Paths& contours);

  /// The smallest contour around the contour `member`; nothing if there is none.
  /// Cost O(log n + k) for k edges met by the ray, plus the number of points of the contours touched by `member`.
  std::optional<std::size_t> smallest_around(std::size_t member) const;
  /// The same for a contour outside the index.
  std::optional<std::size_t> smallest_around(const ClipperLib::Path& inner) const;

 private:
  std::optional<std::size_t> smallest_around(const ClipperLib::Path& inner, std::size_t member) const;
  std::size_t contour_of(std::size_t edge) const;
  /// Calls visit(contour, runs_through) for contours around the point or through it.
  template <typename Visit>
  void visit_around(const ClipperLib::IntPoint& p, Visit&& visit) const;

  const ClipperLib::Paths& contours_;
  std::vector<double> areas_;            ///< signed
  std::vector<Box> boxes_;               ///< in units of the grid, like all following members
  std::vector<std::size_t> first_edge_;  ///< number of the first edge of each contour
  BoxTree edges_;
};

/// For each contour the smallest one around it.
std::vector<std::optional<std::size_t>> contours_around(const ClipperLib::Paths& contours);

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
