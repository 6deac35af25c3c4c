#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "base/text.h"
#include "model/design_element.h"
#include "order/search/solve.h"
#include "pipeline/tour/tour_solver.h"
#include "plan/grid/visit.h"
#include "studies/reproduce/printed_figures.h"
#include "studies/reproduce/published_comparisons.h"
#include "studies/reproduce/reproduce_parts.h"

namespace clearcut::studies {
namespace {

ElementJob job_of(const PrintedReduction& row) {
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

order::Solution shortest_visit(const std::vector<Vec2>& points) {
  order::Problem problem;
  problem.points = points;
  problem.shape = order::Shape::kOpenPath;
  return solved(problem, *order::length_objective(), 1);
}

/// The published algorithm on the same points: its seconds beside the printed ones, and how much longer its path is than the shortest.
Cell genetic_time(const std::vector<Vec2>& points, const char* printed, double printed_s) {
  order::Problem problem;
  problem.points = points;
  problem.shape = order::Shape::kOpenPath;
  const auto found = pipeline::published_order(problem, *order::length_objective(), {});
  const double shortest = shortest_visit(points).bound;
  const std::string text =
      fmt::format("{:.2f} s, +{:.1f} %", found.seconds, 100 * std::max(0.0, found.value / shortest - 1));
  return beside(text, printed, found.seconds <= printed_s ? Agreement::kExplained : Agreement::kDiffers,
                "a genetic algorithm on another machine, and no older one; ours ends after 1000 generations "
                "without gain");
}

/// Milliseconds to the shortest open path, and whether it is proven.
std::string time_to_optimum(const std::vector<Vec2>& points) {
  const auto solution = shortest_visit(points);
  return fmt::format("{:.1f} ms{}", 1000 * solution.seconds, solution.gap < 1e-9 ? "" : " (not proven)");
}

std::vector<std::string> cells_of(const PrintedReduction& row) {
  const auto start = std::chrono::steady_clock::now();
  const ElementJob job = job_of(row);
  PointTable table = plan::grid::tabulate(job);
  order::Solution solution;
  plan::grid::plan_visits(job, table, [&](const std::vector<Vec2>& points) {
    solution = shortest_visit(points);
    return solution.tour;
  });
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  const bool proven = solution.gap < 1e-9;
  return {fmt::format("{0} x {0}", trimmed(row.side, 0)),
          trimmed(row.radius, 1),
          row.rule == MiddleRow::kKeep ? "keep" : "strict",
          std::to_string(table.points.size()),
          std::to_string(count_reduced(table)),
          fmt::format("{:.2f}", solution.length),
          fmt::format("{:.2f}", solution.bound),
          proven ? "optimal" : fmt::format("gap {:.2f} %", 100 * solution.gap),
          fmt::format("{:.1f}", spent.count()),
          row.time_all,
          row.time_reduced};
}

}  // namespace

Reproduction grid_table() {
  Reproduction result;
  result.table.title = "Grid table 1: squares after interpolation and reduction, time of a genetic algorithm";
  result.table.columns = {{"pocket mm"},
                          {"R mm, ours"},
                          {"middle row", Align::kLeft},
                          {"squares, theirs"},
                          {"ours"},
                          {"reduced, theirs"},
                          {"ours"},
                          {"GA on all, theirs"},
                          {"ours"},
                          {"proven optimum"},
                          {"GA on reduced, theirs"},
                          {"ours"},
                          {"proven optimum"}};
  for (const PrintedReduction& row : kPrintedReductions) {
    const PointTable table = plan::grid::tabulate(job_of(row));
    result.add({fmt::format("{0} x {0}", row.side), fmt::format("{}", row.radius),
                row.rule == MiddleRow::kKeep ? "keep" : "strict", std::to_string(row.squares),
                beside(static_cast<double>(table.points.size()), row.squares, 0), std::to_string(row.reduced),
                beside(static_cast<double>(count_reduced(table)), row.reduced, 0), row.time_all,
                genetic_time(points_of(table, false), row.time_all, row.all_s),
                time_to_optimum(points_of(table, false)), row.time_reduced,
                genetic_time(points_of(table, true), row.time_reduced, row.reduced_s),
                time_to_optimum(points_of(table, true))});
  }
  result.table.notes.push_back(
      "tool radii and the rule of the middle row are not printed; these give the printed counts");
  result.table.notes.push_back(
      "ours: the published algorithm of the Tour text (25 individuals, until 1000 generations bring no "
      "gain), and by how much its path is "
      "longer than the proven optimum; on a lattice nearest-neighbour paths begin near it; `clearcut "
      "elements --all-squares` does the "
      "same for any job");
  result.table.notes.push_back(
      "without reduction the squares are a whole lattice, whose shortest path is known at once");
  return result;
}

TextTable grid_reduction_table() {
  TextTable table;
  table.title = "Squares after interpolation and reduction, and the time to an order of visits";
  table.columns = {
      {"pocket mm"},      {"tool R mm"}, {"middle row", Align::kLeft}, {"squares"}, {"reduced"},
      {"visit mm"},       {"bound mm"},  {"proven", Align::kLeft},     {"time ms"}, {"printed all"},
      {"printed reduced"}};
  for (const auto& row : kPrintedReductions) table.add(cells_of(row));
  table.notes = {"Time: interpolation, reduction and search for the shortest open path, on one thread.",
                 "Printed: convergence of a genetic algorithm over all squares and over the reduced ones.",
                 "Tool radii and the rule of the middle row are not printed; these give the printed counts."};
  return table;
}

}  // namespace clearcut::studies
