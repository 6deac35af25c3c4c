// The true shape of a design element: what is to be removed, and the curve the tool's centre follows.
#pragma once

#include <optional>

#include "model/design_element.h"

namespace clearcut::plan::grid {

/// The part of a line or arc where the tool's centre may be: `tool_radius` away from both ends, in a straight
/// line. Absent for other kinds, and where the element is too short for the tool.
std::optional<Edge> core_of(const DesignElement& element, double tool_radius);

/// Everything within `reach` > 0 mm of the straight path; a disc when from == to.
Region stadium(Vec2 from, Vec2 to, double reach);

/// The material of an element, plan view. Lines and arcs must have a core; an arc's radius must exceed the
/// tool's. Exact: lines and arcs.
Region shape_of(const DesignElement& element, double tool_radius);

/// The element as a feature of the part: walls all around, from the stock's top down by its depth.
Feature feature_of(const DesignElement& element, const ElementJob& job);

}  // namespace clearcut::plan::grid
