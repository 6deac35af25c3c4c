// Shortens elastic bands while witnesses hold them. Symmetric 2 x 2 matrices are blocks of the Hessian of a path's
// length.
#pragma once

#include <memory>

#include "geometry/vec2.h"
#include "plan/contour/skeleton/bands.h"
#include "plan/contour/skeleton/tighten.h"

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

/// Settings of one series of Newton steps.
struct Pull {
  int steps = 0;
  double reach = 0;       ///< longest first step, as a share of the tool radius
  double last_reach = 0;  ///< longest last step, as a share of the longest first step
  double soft = 0;        ///< stiffness of the witnesses in the first step, 1 / radius
  double tension = 1;     ///< force shortening the bands; 0: bands only give way to witnesses
};
/// Moves the vertices of bands, and the witnesses kept in the middle between two bands.
///
/// Method  An augmented Lagrangian with Newton steps, see the source file.
/// Cost    O(steps * (vertices + witnesses near the limit)).
class BandMinimiser {
 public:
  /// Both are kept by reference.
  BandMinimiser(Bands& paths, const TightenJob& job);
  ~BandMinimiser();
  BandMinimiser(const BandMinimiser&) = delete;
  BandMinimiser& operator=(const BandMinimiser&) = delete;

  /// Makes Newton steps: long and soft at first, short and stiff at the end. A witness pulls a band farther than
  /// `limit` mm away. Bands stay in the legal area.
  void relax(const Pull& pull, double limit);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clearcut::plan::contour
