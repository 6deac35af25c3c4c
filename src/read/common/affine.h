// Affine maps of the plane: block references, SVG transforms, units.
#pragma once

#include <cmath>

#include "base/elementary.h"
#include "geometry/vec2.h"

namespace clearcut::read {

/// p -> (a x + c y + e, b x + d y + f), the letters of SVG's matrix().
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  static Affine translation(Vec2 by) { return {1, 0, 0, 1, by.x, by.y}; }
  static Affine scaling(double x, double y) { return {x, 0, 0, y, 0, 0}; }
  static Affine rotation(double radians) {
    const double cosine = base::cos(radians), sine = base::sin(radians);
    return {cosine, sine, -sine, cosine, 0, 0};
  }

  Vec2 operator()(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// Image of a direction: without the shift.
  Vec2 linear(Vec2 v) const { return {a * v.x + c * v.y, b * v.x + d * v.y}; }
  double determinant() const { return a * d - b * c; }
  bool mirrors() const { return determinant() < 0; }
  /// Circles stay circles (to 1e-9 relative).
  bool is_similarity() const {
    const Vec2 u{a, b}, v{c, d};
    const double size = norm(u) + norm(v);
    return std::abs(norm(u) - norm(v)) <= 1e-9 * size && std::abs(dot(u, v)) <= 1e-9 * size * size;
  }
  /// `*this` after `first`.
  Affine operator*(const Affine& first) const {
    const Vec2 u = linear({first.a, first.b}), v = linear({first.c, first.d}),
               t = (*this)({first.e, first.f});
    return {u.x, u.y, v.x, v.y, t.x, t.y};
  }
};

}  // namespace clearcut::read
