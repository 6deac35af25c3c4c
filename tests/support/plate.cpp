#include "support/plate.h"

#include <sstream>
#include <stdexcept>

#include "features/standing.h"
#include "geometry/contours/boolean.h"

namespace clearcut::test_support {
namespace {

Region rectangle(double x0, double y0, double x1, double y1) {
  return Region::from_valid_loops(loop_from_points(std::vector<Vec2>{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}),
                                  {});
}

Region rounded_slot(Vec2 a, Vec2 b, double radius) {
  const Vec2 side{0, radius};
  return Region::from_valid_loops(
      {Edge::line(a - side, b - side), Edge::arc(b - side, b + side, b, Turn::kCounterClockwise),
       Edge::line(b + side, a + side), Edge::arc(a + side, a - side, a, Turn::kCounterClockwise)},
      {});
}

Region disc(Vec2 c, double radius) {
  const Vec2 r{radius, 0};
  return Region::from_valid_loops({Edge::arc(c + r, c - r, c, Turn::kCounterClockwise),
                                   Edge::arc(c - r, c + r, c, Turn::kCounterClockwise)},
                                  {});
}

Feature closed(const std::string& name, FeatureKind kind, double depth, Region region) {
  Feature feature;
  feature.name = name;
  feature.kind = kind;
  feature.floor_z = -depth;
  feature.target = feature.allowed = {std::move(region)};
  return feature;
}

/// A feature whose sides are open where `boundary` leaves the stock.
Feature open(const std::string& name, FeatureKind kind, double depth, const Region& boundary,
             const Box& stock) {
  const Region block = rectangle(stock.min.x, stock.min.y, stock.max.x, stock.max.y);
  const Box reach = stock.grown(kOpenReach);
  const Region all = rectangle(reach.min.x, reach.min.y, reach.max.x, reach.max.y);
  const Region air = Region::from_valid_loops(all.outer(), {reversed(block.outer())});
  Feature feature = closed(name, kind, depth, boundary);
  feature.target = intersect({boundary}, {block}, {});
  feature.allowed = unite({boundary}, {air}, {});
  return feature;
}

Tool tool(int number, ToolKind kind, double diameter) {
  Tool tool;
  tool.number = number;
  tool.name = "T" + std::to_string(number);
  tool.kind = kind;
  tool.diameter = diameter;
  return tool;
}

Workingstep step(const std::string& name, int feature, int tool, OperationKind kind) {
  Operation operation;
  operation.name = name;
  operation.kind = kind;
  operation.tool = tool;
  operation.cutting.feed = MmPerMin::of(600);
  operation.cutting.spindle_rpm = 900.0 + 100 * feature;
  return {name, "", feature, operation};
}

}  // namespace

Part plate() {
  Part part;
  part.name = "PLATE";
  part.stock = Stock{{{0, 0}, {100, 100}}, -40, 0};
  part.clearance_z = 10;
  part.tools = {tool(1, ToolKind::kEndMill, 8), tool(2, ToolKind::kDrill, 11.8),
                tool(3, ToolKind::kReamer, 12)};
  part.features = {closed("HOLE", FeatureKind::kRoundHole, 10, disc({20, 10}, 6)),
                   open("SLOT", FeatureKind::kSlot, 7, rectangle(-5, 72, 105, 88), part.stock->plan),
                   open("STEP", FeatureKind::kStep, 12, rectangle(87, -5, 105, 105), part.stock->plan),
                   closed("POCKET", FeatureKind::kClosedPocket, 15, rectangle(15, 20, 45, 60)),
                   closed("ROUNDED SLOT", FeatureKind::kSlot, 6, rounded_slot({55, 40}, {75, 40}, 4))};
  part.features[0].hole_diameter = 12;
  part.workplan = {step("DRILL", 0, 1, OperationKind::kDrilling),
                   step("REAM", 0, 2, OperationKind::kReaming),
                   step("MILL SLOT", 1, 0, OperationKind::kRoughing),
                   step("MILL STEP", 2, 0, OperationKind::kRoughing),
                   step("MILL POCKET", 3, 0, OperationKind::kRoughing),
                   step("MILL ROUNDED SLOT", 4, 0, OperationKind::kRoughing)};
  features::stack_tops(part, {});
  part.diagnostics = {};
  return part;
}

std::string with_instances_reversed(const std::string& text) {
  const auto begin = text.find('#', text.find("DATA;")), end = text.find("ENDSEC;", begin);
  if (begin == std::string::npos || end == std::string::npos) throw std::runtime_error("no instances");
  std::vector<std::string> instances;
  std::istringstream lines(text.substr(begin, end - begin));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#") || instances.empty()) instances.emplace_back();
    instances.back() += line + "\n";
  }
  std::string result = text.substr(0, begin);
  for (auto i = instances.rbegin(); i != instances.rend(); ++i) result += *i;
  return result + text.substr(end);
}

}  // namespace clearcut::test_support
