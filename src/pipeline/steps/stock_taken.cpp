#include "pipeline/steps/stock_taken.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/format.h"

namespace clearcut::pipeline {
namespace {

/// mm, for heights rounded by the coarsest controller (0.0001 inch).
constexpr double kHeightSlack = 5.5e-3;

double low_z(const Move& move) {
  return std::min(move.z_from, move.z_to);
}

double radius_of(const Section& section, const std::vector<Tool>& tools) {
  const Tool* const tool = tool_numbered(tools, section.tool_number);
  return tool ? tool->radius() : 0;
}

int line_of_move(const Toolpath& toolpath, std::size_t index) {
  for (const Section& section : toolpath.sections) {
    if (index < section.moves.size()) return section.moves[index].line;
    index -= section.moves.size();
  }
  return 0;
}

}  // namespace

std::optional<Stock> box_of_cuts(const Toolpath& toolpath, const std::vector<Tool>& tools, double top) {
  Stock stock;
  stock.z_top = stock.z_bottom = top;
  for (const Section& section : toolpath.sections) {
    const double radius = radius_of(section, tools);
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind) || low_z(move) >= top) continue;
      const Box path = move.path.box();
      stock.plan.add(path.grown(radius));
      stock.z_bottom = std::min(stock.z_bottom, low_z(move));
    }
  }
  if (stock.plan.empty()) return std::nullopt;
  return stock;
}

const Move* work_above(const Toolpath& toolpath, double top) {
  const Move* highest = nullptr;
  double crossing = top;   // height of the highest rapid across so far
  bool came_down = false;  // the tool came down to the current height, not up
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      const bool across = !move.is_vertical(), feeds = !is_rapid(move.kind);
      if (!feeds && across) crossing = std::max(crossing, move.z_to);
      if (move.z_to < move.z_from) came_down = feeds || move.z_to < crossing - kHeightSlack;
      if (move.z_to > move.z_from) came_down = false;
      const bool works = feeds && across && move.z_from <= move.z_to + kHeightSlack && came_down;
      if (!works || low_z(move) <= top + kHeightSlack) continue;
      if (!highest || move.z_to > highest->z_to) highest = &move;
    }
  }
  return highest;
}

Condition stock_taken(const Stock& stock) {
  const auto range = [](const char* axis, double low, double high) {
    return fmt::format("{} {} to {}", axis, trimmed(low, 3), trimmed(high, 3));
  };
  return {
      "stock",
      fmt::format("no stock was stated (--stock): the box of what the program cuts is taken, {}, {}, {}",
                  range("x", stock.plan.min.x, stock.plan.max.x),
                  range("y", stock.plan.min.y, stock.plan.max.y), range("z", stock.z_bottom, stock.z_top)),
      0};
}

std::optional<Condition> below_stock(const Toolpath& toolpath, const Stock& stock) {
  const Move* deepest = nullptr;
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      if (!is_rapid(move.kind) && (!deepest || low_z(move) < low_z(*deepest))) deepest = &move;
    }
  }
  const double below = deepest ? stock.z_bottom - low_z(*deepest) : 0;
  if (below <= kHeightSlack) return std::nullopt;
  return Condition{"below-stock",
                   fmt::format("what the stock lies on may be cut {} mm deep, down to z {}",
                               trimmed(below, 3), trimmed(low_z(*deepest), 3)),
                   deepest->line};
}

std::optional<Condition> doubtful_arcs(const Toolpath& toolpath, const ControlTable& control,
                                       const Tolerances& tol) {
  const auto worst =
      std::max_element(control.arcs.begin(), control.arcs.end(),
                       [](const ArcDoubt& a, const ArcDoubt& b) { return a.apart_mm < b.apart_mm; });
  if (worst == control.arcs.end() || worst->apart_mm <= tol.uncut) return std::nullopt;
  return Condition{
      "arc-radii",
      fmt::format("the words of an arc give two radii {} mm apart: controls run another arc, or stop",
                  trimmed(worst->apart_mm, 3)),
      line_of_move(toolpath, worst->move)};
}

std::optional<Condition> cuts_nothing(const Findings& findings) {
  if (findings.all.max_axial_mm > 0) return std::nullopt;
  return Condition{
      "cuts-nothing",
      "no feed move meets the stock: nothing is to be cut, or the stock is stated where it is not (--stock, "
      "--top)",
      0};
}

}  // namespace clearcut::pipeline
