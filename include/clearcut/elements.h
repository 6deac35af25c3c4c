// Jobs of design elements (lines, arcs, pockets, holes, slots on a grid): read, planned, shown.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "clearcut/plan.h"
#include "clearcut/text.h"
#include "model/design_element.h"
#include "model/runs/elements_result.h"
#include "options/element_options.h"

namespace clearcut {

/// The elements with their squares, reduced squares and lengths of visit.
TextTable element_table(const ElementsResult& result);

/// Checks the job, tabulates and reduces its elements, orders the visits, and makes a checked program of them.
/// options: post, machine, tol, seed, time_s (longest search for one order, default 2 s), progress (called before
/// each search), cancel are used; the rest comes from the job. Material left uncut by the reduction is in the
/// findings, as everywhere. Throws InputError with all faults of the job on one line.
ElementsResult plan_elements(const ElementJob& job, const PlanOptions& options);

/// What the published genetic algorithm makes of the squares of every element of a tabulated job. Ends as options.published.solver says, else after 1000 generations without gain.
std::vector<SquareSearch> search_squares(const ElementJob& job, const PointTable& points,
                                         const PlanOptions& options);

/// A row for each search.
TextTable square_table(const std::vector<SquareSearch>& searches);

/// The job in the options' order. Only the form is checked here, as for job files. Throws InputError naming the
/// option.
ElementJob elements_of_options(const std::vector<ElementOption>& options, const ElementDefaults& defaults);

/// TOML: name, resolution (mm), middle_row = "keep" or "strict", [stock] with x, y, z = [low, high],
/// [[tool]] and [[element]]; docs/grid.md lists every key. Only the form is checked here; whether the
/// elements can be made is checked by the planner, all faults at once. Throws InputError "file:line: ...".
/// Cost O(length).
ElementJob read_elements(const std::filesystem::path& file);
ElementJob read_elements_text(std::string_view text, const std::string& file_name);

/// Shape   one HTML document without network access and without scripts: the job's elements and tools, the squares
///         activated and reduced and the tool's impact (grid_picture), the visit as an animated picture, a
///         convergence graph for each order with search steps, and the table of all points.
/// Units   mm in the part's frame. Cost O(points + moves).
std::string grid_page(const ElementJob& job, const PointTable& table, const Toolpath& toolpath,
                      const std::vector<VisitSearch>& searches);

/// Shape   one SVG document with three panels beside each other: the activated squares of every element, the
///         reduced ones, and the tool's impact with the visits in the order of `toolpath` (the grid paper's
///         figures 8, 14, 21 and 24). Each element has its colour in all panels.
/// Units   mm in the part's frame. Cost O(points + moves).
std::string grid_picture(const ElementJob& job, const PointTable& table, const Toolpath& toolpath);

/// The decision maker's table: one line a point, comma separated, with a heading, in the table's order.
std::string points_csv(const ElementJob& job, const PointTable& table);

/// The table of points for people.
TextTable points_table(const ElementJob& job, const PointTable& table);

}  // namespace clearcut
