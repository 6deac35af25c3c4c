// The interpolators of the grid model: which squares an element activates.
// Source: the grid paper, section II; docs/grid.md says where we leave it.
#pragma once

#include <array>
#include <vector>

#include "model/design_element.h"

namespace clearcut::plan::grid {

/// Points on the straight path, both ends included: max(2, ceil(3 distance / cell)) of them at regular steps
/// of the coordinate with the longer extent.
std::vector<Vec2> interpolate_line(Vec2 from, Vec2 to, double cell);

/// The two centres of circles of `radius` through both points; the first lies on the left of from -> to.
/// `radius` is at least half the distance (to rounding).
std::array<Vec2, 2> arc_centers(Vec2 from, Vec2 to, double radius);
/// The arc of at most half a turn from `from` to `to` in the element's direction.
Edge arc_of(const DesignElement& arc);

/// Step in x of the circular interpolator: 0.001 mm, less where the steep ends of a large circle would jump
/// by more than a third of a square. mm.
double circle_step(double radius, double cell);
/// The full circle about (0, 0): x from -radius to radius in steps, upper half, then mirrored. Clockwise.
std::vector<Vec2> circle_at_origin(double radius, double step);
/// Points of the arc from its first to its last: circle, shift, trim by direction.
std::vector<Vec2> interpolate_arc(const Edge& arc, double cell);

/// The squares nearest to the points, each once, in the order of first touch.
std::vector<Square> activate(const std::vector<Vec2>& points, const SquareGrid& grid);
/// The squares of a rectangle row by row from its lower left corner: round(length / cell) + 1 in a row.
std::vector<Square> activate_rectangle(const DesignElement& rectangle, const SquareGrid& grid);
/// The squares whose centre is within `reach` mm of the straight path, row by row.
std::vector<Square> activate_near(Vec2 from, Vec2 to, double reach, const SquareGrid& grid);

/// The squares of any element. Cost O(squares), arcs O(radius / circle_step).
std::vector<Square> interpolate(const DesignElement& element, const SquareGrid& grid);

}  // namespace clearcut::plan::grid
