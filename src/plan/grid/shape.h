// The exact shape of a design element, the material to be removed and the curve of the cutter's centre, and the check
// of a job's elements before they are interpolated and reduced.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/design_element.h"

namespace clearcut::plan::grid {

/// The part of a line or arc permitted to the cutter's centre: at least `tool_radius` mm from both ends of
/// the element, in a straight line. Nothing for other elements and for those too short for the tool.
std::optional<Edge> core_of(const DesignElement& element, double tool_radius);

/// All points within `reach` mm (> 0) of the line from `from` to `to`; a disc if both are equal.
Region stadium(Vec2 from, Vec2 to, double reach);

/// The material of an element in plan view, exact: bounded by lines and arcs. Lines and arcs must have a
/// core, and an arc's radius must exceed the tool's.
Region shape_of(const DesignElement& element, double tool_radius);

/// The element as a feature of the part: walls all round, from the top of the stock down by its depth.
Feature feature_of(const DesignElement& element, const ElementJob& job);

struct ElementFault {
  std::string place;  ///< "file:line element 'id'"
  std::string text;   ///< the wrong size, and the remedy
};

/// Every fault of every element, in the elements' order; empty for a valid job.
std::vector<ElementFault> faults_of(const ElementJob& job);

/// Throws one InputError with all faults on one line.
void check(const ElementJob& job);

/// Elements off the grid, so that their squares are off by up to half a square. A warning, no
/// fault.
std::vector<ElementFault> off_grid(const ElementJob& job);

}  // namespace clearcut::plan::grid
