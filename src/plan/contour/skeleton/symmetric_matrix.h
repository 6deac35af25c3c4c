// Symmetric 2 x 2 matrices: blocks of the Hessian of a path's length.
#pragma once

#include "geometry/vec2.h"

namespace clearcut::plan::contour {

/// A symmetric 2 x 2 matrix.
struct Sym2 {
  double xx = 0, xy = 0, yy = 0;
  Sym2& operator+=(const Sym2& o) {
    xx += o.xx;
    xy += o.xy;
    yy += o.yy;
    return *this;
  }
  friend Sym2 operator*(const Sym2& m, double k) { return {m.xx * k, m.xy * k, m.yy * k}; }
  friend Vec2 operator*(const Sym2& m, Vec2 v) { return {m.xx * v.x + m.xy * v.y, m.xy * v.x + m.yy * v.y}; }
  Sym2 inverse() const {
    const double det = xx * yy - xy * xy;
    return {yy / det, -xy / det, xx / det};
  }
  /// this * inner * this
  Sym2 around(const Sym2& inner) const {
    const Vec2 c0 = inner * Vec2{xx, xy}, c1 = inner * Vec2{xy, yy};
    return {xx * c0.x + xy * c0.y, xx * c1.x + xy * c1.y, xy * c1.x + yy * c1.y};
  }
};

inline Sym2 outer_product(Vec2 u) {
  return {u.x * u.x, u.x * u.y, u.y * u.y};
}

}  // namespace clearcut::plan::contour
