// Pictures and tables of the grid model, and its working screen as one page: elements and tools, squares before and
// after, visit, convergence.
#pragma once

#include <string>
#include <vector>

#include "model/design_element.h"
#include "model/move.h"
#include "model/runs/elements_result.h"
#include "report/words/text_table.h"

namespace clearcut::report {

/// Shape   one SVG document with three panels beside each other: the activated squares of every element, the
///         reduced ones, and the tool's impact with the visits in the order of `toolpath` (the grid paper's
///         figures 8, 14, 21 and 24). Each element has its colour in all panels.
/// Units   mm in the part's frame. Cost O(points + moves).
std::string grid_picture(const ElementJob& job, const PointTable& table, const Toolpath& toolpath);

/// The decision maker's table: one line a point, comma separated, with a heading, in the table's order.
std::string points_csv(const ElementJob& job, const PointTable& table);

/// The same for people.
TextTable points_table(const ElementJob& job, const PointTable& table);

/// Shape   one HTML document without network access and without scripts: the job's elements and tools, the squares
///         activated and reduced and the tool's impact (grid_picture), the visit as an animated picture, a
///         convergence graph for each order with search steps, and the table of all points.
/// Units   mm in the part's frame. Cost O(points + moves).
std::string grid_page(const ElementJob& job, const PointTable& table, const Toolpath& toolpath,
                      const std::vector<VisitSearch>& searches);

}  // namespace clearcut::report
