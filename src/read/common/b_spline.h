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

/// What is wrong with its degree, its weights or the numbers of its parts: "3 knots for 2 control points of degree 3"; or
/// where it is torn: "a tear of 5 mm at knot 0.5". "" if nothing.
std::string fault_of(const BSpline& spline);

/// Appends the whole spline, which must have no fault, within `tolerance` mm.
/// Source  de Boor's algorithm on homogeneous points, knot span by knot span.
void append_spline(const BSpline& spline, double tolerance, Path& out);

/// Appends a smooth curve that may come back to where it began: in halves, joined to what is there.
void append_span(const std::function<Vec2(double)>& curve, double tolerance, Path& out);

}  // namespace clearcut::read
