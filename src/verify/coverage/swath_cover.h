// The cells of the proof of coverage, small convex polygons: whether swaths cover them and run along a curve, and the
// material that must remain on walls.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "verify/coverage/coverage.h"

namespace clearcut::verify {

/// A convex polygon of few vertices, counter-clockwise, without allocation. The polygon may have shrunk to a line or
/// a point, and is empty if size() == 0.
class ConvexPolygon {
 public:
  static constexpr int kCapacity = 64;

  ConvexPolygon() = default;
  static ConvexPolygon square(Vec2 center, double half);
  /// Convex hull of the points; for more than 48 points their bounding box.
  static ConvexPolygon hull(std::span<Vec2> points);

  int size() const { return count_; }
  bool empty() const { return count_ == 0; }
  std::span<const Vec2> points() const { return {points_.data(), static_cast<std::size_t>(count_)}; }
  Vec2 centroid() const;
  double area() const;
  /// The part with dot(normal, p) >= offset.
  ConvexPolygon clipped(Vec2 normal, double offset) const;
  double farthest_from(Vec2 p) const;
  /// Distance from p; 0 inside.
  double nearest_to(Vec2 p) const;

 private:
  void add(Vec2 p);
  std::array<Vec2, kCapacity> points_{};
  int count_ = 0;
};

/// mm; upper bound of the distance of the points of `cell` outside the swath; negative if all are inside.
double excess_over(const ConvexPolygon& cell, const Swath& swath);

/// A convex polygon around the part of `cell` left by the swath; at worst the cell itself.
ConvexPolygon rest_after(const ConvexPolygon& cell, const Swath& swath);

/// mm; upper bound of the distance of the points of `curve` from the swath's path.
double deviation_of(const Edge& curve, const Edge& path);

/// Adds points whose convex hull holds the part of an edge inside a square.
void append_extremes(const Edge& edge, const Box& square, std::vector<Vec2>& out);

/// The material to remain at the height of a question. Keeps a reference to the question.
class WallResidual {
 public:
  explicit WallResidual(const CoverageQuestion& question);

  /// Whether there may be any.
  bool may_be() const { return question_.allowance > 0 || greatest_draft_ > 0; }
  /// Whether p is in the material to be left on a wall.
  bool holds(Vec2 p) const;
  /// Whether some point within `reach` mm of `center` may be in it.
  bool may_hold(Vec2 center, double reach) const;
  /// Whether the whole `polygon`, located within `reach` mm of `center`, is in the material to be left on one wall.
  bool holds_on_one_wall(const ConvexPolygon& polygon, Vec2 center, double reach) const;

 private:
  bool wall_holds(const Wall& wall, const ConvexPolygon& polygon, Vec2 center, double reach) const;

  const CoverageQuestion& question_;
  double greatest_draft_ = 0;  ///< mm; of all walls at the height of the question
  std::vector<Wall> beyond_;   ///< outlines beside the stock with an allowance that may extend into the stock
};

}  // namespace clearcut::verify
