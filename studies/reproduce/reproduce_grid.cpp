#include "studies/reproduce/reproduce_grid.h"

#include <fmt/format.h>

#include <array>

#include "model/design_element.h"
#include "order/solve.h"
#include "plan/grid/visit.h"
#include "studies/reproduce/published_grids.h"

namespace clearcut::studies {
namespace {

/// A printed row, with the radius and the rule that give its counts: the paper prints neither.
struct PrintedRow {
  double side, radius;  ///< mm
  MiddleRow rule;
  int squares, reduced;
  const char* time_all;
  const char* time_reduced;
};

constexpr std::array<PrintedRow, 6> kTable1{{{10, 2, MiddleRow::kKeep, 121, 16, "> 3 h", "85 s"},
                                             {12, 2, MiddleRow::kKeep, 169, 25, "> 5 h", "160 s"},
                                             {20, 3, MiddleRow::kKeep, 441, 36, "> 10 h", "7.5 min"},
                                             {20, 4, MiddleRow::kKeep, 441, 16, "> 10 h", "85 s"},
                                             {30, 3, MiddleRow::kKeep, 961, 81, "> 1 day", "20 min"},
                                             {30, 3, MiddleRow::kStrict, 961, 64, "> 1 day", "12 min"}}};

ElementJob job_of(const PrintedRow& row) {
  ElementJob job;
  job.name = "square";
  job.stock = {{{0, 0}, {row.side, row.side}}, -1, 0};
  job.middle_row = row.rule;
  Tool tool;
  tool.diameter = 2 * row.radius;
  job.tools = {tool};
  DesignElement square;
  square.id = "square";
  square.length = square.width = row.side;
  square.depth = 1;
  job.elements = {square};
  return job;
}

/// Points to visit: all squares, or those that the reduction kept.
std::vector<Vec2> points_of(const PointTable& table, bool reduced) {
  std::vector<Vec2> points;
  for (const GridPoint& point : table.points)
    if (!reduced || point.reduced) points.push_back(point.at);
  return points;
}

/// Milliseconds to the shortest open path, judged against the printed time of a genetic algorithm.
Cell time_to_optimum(std::vector<Vec2> points, const char* printed) {
  order::Problem problem;
  problem.points = std::move(points);
  problem.shape = order::Shape::kOpenPath;
  const auto solution = solved(problem, *order::length_objective(), 1);
  const bool proven = solution.gap < 1e-9;
  return beside(fmt::format("{:.1f} ms{}", 1000 * solution.seconds, proven ? "" : " (not proven)"), printed,
                proven ? Agreement::kExplained : Agreement::kDiffers,
                "theirs is a genetic algorithm; ours is proven optimal");
}

}  // namespace

Reproduction grid_table() {
  Reproduction result;
  result.table.title = "Grid table 1: squares after interpolation and reduction, time to the optimal order";
  result.table.columns = {{"pocket mm"},
                          {"R mm, ours"},
                          {"middle row", report::Align::kLeft},
                          {"squares, theirs"},
                          {"ours"},
                          {"reduced, theirs"},
                          {"ours"},
                          {"time all, theirs"},
                          {"ours"},
                          {"time reduced, theirs"},
                          {"ours"}};
  for (const PrintedRow& row : kTable1) {
    const PointTable table = plan::grid::tabulate(job_of(row));
    result.add({fmt::format("{0} x {0}", row.side), fmt::format("{}", row.radius),
                row.rule == MiddleRow::kKeep ? "keep" : "strict", std::to_string(row.squares),
                beside(static_cast<double>(table.points.size()), row.squares, 0), std::to_string(row.reduced),
                beside(static_cast<double>(count_reduced(table)), row.reduced, 0), row.time_all,
                time_to_optimum(points_of(table, false), row.time_all), row.time_reduced,
                time_to_optimum(points_of(table, true), row.time_reduced)});
  }
  result.table.notes.push_back(
      "tool radii and the rule of the middle row are not printed; these give the printed counts");
  result.table.notes.push_back(
      "without reduction the squares are a whole lattice, whose shortest path is known at once");
  return result;
}

}  // namespace clearcut::studies
