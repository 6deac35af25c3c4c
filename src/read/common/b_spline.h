// Rational B-splines as lines and arcs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geometry/edge.h"

namespace clearcut::read {

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
