// Which contours of polyclipping lie in which.
#pragma once

#include <cstddef>
#include <optional>
#include <polyclipping/clipper.hpp>
#include <vector>

#include "geometry/spatial/box_tree.h"

namespace clearcut::inline geometry {

/// Finds the contours about another one, by a ray from one of its points. Keeps a reference to `contours`, which must outlive it.
/// Contours must not cross each other; they may touch. Those that lie in one and in nothing between turn the other way round, as
/// polyclipping returns them: of two that turn alike and share an edge each lies beside the other. Built in O(n) for n points.
class ContourIndex {
 public:
  explicit ContourIndex(const ClipperLib::Paths& contours);

  /// The smallest contour that contour `member` lies in; nothing where it lies in none.
  /// Cost O(log n + k) for k edges that the ray meets, and the points of those contours that `member` touches.
  std::optional<std::size_t> smallest_around(std::size_t member) const;
  /// The same for a contour that is no member.
  std::optional<std::size_t> smallest_around(const ClipperLib::Path& inner) const;

 private:
  std::optional<std::size_t> smallest_around(const ClipperLib::Path& inner, std::size_t member) const;
  std::size_t contour_of(std::size_t edge) const;
  /// Calls visit(contour, runs_through) for contours that hold the point or run through it.
  template <typename Visit>
  void visit_around(const ClipperLib::IntPoint& p, Visit&& visit) const;

  const ClipperLib::Paths& contours_;
  std::vector<double> areas_;            ///< signed
  std::vector<Box> boxes_;               ///< in units of the grid, like all that follows
  std::vector<std::size_t> first_edge_;  ///< of each contour
  BoxTree edges_;
};

/// For each contour the smallest that it lies in.
std::vector<std::optional<std::size_t>> contours_around(const ClipperLib::Paths& contours);

}  // namespace clearcut::inline geometry
