// Mends within one curve or outline: numbers, edges without length, arcs whose radii disagree, arcs divided into many
// short lines, neighbours crossing again near their joint.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "read/repair/joining.h"
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

/// mm. Greatest distance of a run's vertices from its arc: the rounding of coordinates in drawings.
inline constexpr double kArcVertexTolerance = 0.001;
/// mm. Greatest distance of the middles of its lines: finer than any outline with intended corners.
inline constexpr double kArcChordTolerance = 0.005;
/// Runs shorter than this stay lines.
inline constexpr std::size_t kFewestChords = 5;

/// Replaces runs of lines with turns in one direction and with vertices and middles on one circle, to within the
/// tolerances above: never across a corner, never a coarse polygon. Reports the numbers of replaced lines and of
/// arcs. Cost O(n log n).
void find_arcs(std::vector<RawLoop>& loops, const RepairOptions& options, Diagnostics& diagnostics);

/// Neighbours meeting a second time are joined there, without the sliver between, if it is no thicker than
/// tol.join_gap. Reports each with its thickness. Cost O(n).
void trim_joints(std::vector<RawLoop>& loops, const RepairOptions& options, Diagnostics& diagnostics);

}  // namespace clearcut::read
