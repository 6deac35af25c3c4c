// Mends within one curve: numbers, edges without length, arcs whose radii disagree.
#pragma once

#include <string>
#include <vector>

#include "read/repair/repair.h"

namespace clearcut::read {

/// Edges shorter than this are merged into their neighbours, mm: the last digit a program is written with.
inline constexpr double kTinyEdge = 1e-4;

/// The arc from `from` through `through` to `to`; a line if the three are collinear within 1 nm.
Edge arc_through(Vec2 from, Vec2 through, Vec2 to);
/// `edge` with its ends moved to `from` and `to` (small moves): arcs keep the middle of their curve.
Edge with_ends(const Edge& edge, Vec2 from, Vec2 to);
/// The closed loop without edges below kTinyEdge, left by booleans of nearly touching curves; may be empty.
Loop without_tiny_edges(const Loop& loop);
/// A full circle as two half circles, counter-clockwise, from its right-most point.
Path full_circle(Vec2 center, double radius);

/// Throws  InputError when a number of the curve is not finite or reaches beyond kLargestCoordinate.
void check_numbers(const RawCurve& curve, const std::string& where);

/// Every curve with consistent arcs and without edges below kTinyEdge (runs of tiny edges keep their
/// course); curves without any length are dropped. Throws InputError for arcs whose radii differ by more
/// than tol.join_gap.
std::vector<RawCurve> clean(std::vector<RawCurve> curves, const RepairOptions& options,
                            Diagnostics& diagnostics);

}  // namespace clearcut::read
