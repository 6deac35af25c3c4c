// Small convex polygons, the cells of the proof of coverage.
#pragma once

#include <array>
#include <span>

#include "geometry/box.h"

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

}  // namespace clearcut::verify
