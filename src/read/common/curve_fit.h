// Ellipses, Bezier curves and rational B-splines as lines and tangent arcs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geometry/edge.h"
#include "read/common/affine.h"

namespace clearcut::read {

/// Greatest distance between a curve of a drawing and the lines and arcs replacing it, mm.
inline constexpr double kCurveTolerance = 0.002;

/// A smooth curve: its points for t in [0, 1].
using ParametricCurve = std::function<Vec2(double)>;

/// Appends lines and pairs of tangent arcs (biarcs) along `curve`.
///
/// Error   every sampled place of the curve is within `tolerance` of them, seven per pair.
/// Cost    O(pieces); at most 2^14 pieces, below this a kink in the curve is left unchanged.
/// Source  the biarc with equal tangent lengths, Bolton 1975; halved if not near enough.
void append_fitted(const ParametricCurve& curve, double tolerance, Path& out);

/// Appends `edge` under `map`: exactly for lines and under similarities, else (ellipses) fitted.
void append_mapped(const Edge& edge, const Affine& map, double tolerance, Path& out);

/// The elliptical arc center + cos(t) u + sin(t) v for t from `start` through `sweep`.
struct EllipticArc {
  Vec2 center;
  Vec2 u, v;         ///< conjugate radii
  double start = 0;  ///< radians
  double sweep = 0;  ///< radians, signed
};

/// Appends the arc. If u and v are perpendicular and equally long: an exact circular arc. A full turn gives a
/// closed run.
void append_elliptical(const EllipticArc& arc, double tolerance, Path& out);

struct BSpline {
  struct Pole {
    Vec2 p;  ///< times its weight
    double w = 1;
  };
  int degree = 3;
  std::vector<double> knots;
  std::vector<Pole> poles;
};

/// The fault of its degree, its weights or the numbers of its parts: "3 knots for 2 control points of degree 3"; or
/// the place of a gap: "a tear of 5 mm at knot 0.5". "" if there is none.
std::string fault_of(const BSpline& spline);

/// Appends the whole spline, which must have no fault, within `tolerance` mm.
/// Source  de Boor's algorithm on homogeneous points, knot span by knot span.
void append_spline(const BSpline& spline, double tolerance, Path& out);

/// Appends a smooth curve, possibly returning to its start: in halves, joined to the existing path.
void append_span(const std::function<Vec2(double)>& curve, double tolerance, Path& out);

}  // namespace clearcut::read
