// Axis-parallel box in mm.
#pragma once

#include <algorithm>
#include <limits>

#include "base/elementary.h"
#include "geometry/vec2.h"

namespace clearcut::inline geometry {

/// Empty when min > max (the default).
struct Box {
  Vec2 min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  bool empty() const { return min.x > max.x || min.y > max.y; }
  double width() const { return max.x - min.x; }
  double height() const { return max.y - min.y; }
  Vec2 center() const { return (min + max) / 2.0; }
  void add(Vec2 p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  }
  void add(const Box& b) {
    if (!b.empty()) {
      add(b.min);
      add(b.max);
    }
  }
  Box grown(double by) const { return {{min.x - by, min.y - by}, {max.x + by, max.y + by}}; }
  bool contains(Vec2 p) const { return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y; }
  bool overlaps(const Box& b) const {
    return min.x <= b.max.x && b.min.x <= max.x && min.y <= b.max.y && b.min.y <= max.y;
  }
  /// Distance from p to the box, 0 inside.
  double distance_to(Vec2 p) const {
    const double dx = std::max({min.x - p.x, 0.0, p.x - max.x});
    const double dy = std::max({min.y - p.y, 0.0, p.y - max.y});
    return base::hypot(dx, dy);
  }
};

}  // namespace clearcut::inline geometry
