// The interpolators of the grid model: the squares of the grid occupied by an element ("activates", in the
// paper).
// Source: the grid paper, section II; docs/grid.md lists the departures.
#pragma once

#include <array>
#include <vector>

#include "model/design_element.h"

namespace clearcut::plan::grid {

/// Points on the line, both ends included: max(2, ceil(3 distance / cell)) of them, at equal steps of the
/// coordinate with the greater extent. mm.
std::vector<Vec2> interpolate_line(Vec2 from, Vec2 to, double cell);

/// The two centres of circles of `radius` mm through both points; the first is on the left of from -> to.
/// `radius` is at least half the distance, up to rounding.
std::array<Vec2, 2> arc_centers(Vec2 from, Vec2 to, double radius);
/// The arc of at most half a turn between the ends of the element, in its direction.
Edge arc_of(const DesignElement& arc);

/// mm; step in x of the circular interpolator: 0.001 mm, or less if a steep part of the circle would jump by
/// more than a third of a square.
double circle_step(double radius, double cell);
/// The points of the full circle about (0, 0), clockwise: x from -radius to radius in steps of `step` mm, the
/// upper half, then mirrored.
std::vector<Vec2> circle_at_origin(double radius, double step);
/// Points of the arc from its first to its last: a circle at the origin, shifted to the centre, trimmed to
/// the arc.
std::vector<Vec2> interpolate_arc(const Edge& arc, double cell);

/// The squares nearest to the points, each once, in the order of first contact.
std::vector<Square> activate(const std::vector<Vec2>& points, const SquareGrid& grid);
/// The squares of a rectangle, row by row from its lower left corner: round(length / cell) + 1 in a row.
std::vector<Square> activate_rectangle(const DesignElement& rectangle, const SquareGrid& grid);
/// The squares whose centre is within `reach` mm of the line, row by row.
std::vector<Square> activate_near(Vec2 from, Vec2 to, double reach, const SquareGrid& grid);

/// The squares of an element. Cost O(squares); for arcs O(radius / circle_step).
std::vector<Square> interpolate(const DesignElement& element, const SquareGrid& grid);

}  // namespace clearcut::plan::grid
