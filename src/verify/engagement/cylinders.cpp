#include "verify/engagement/cylinders.h"

#include <algorithm>
#include <cmath>

#include "verify/faults/shaped_cutter.h"

namespace clearcut::verify {
namespace {

/// mm sideways, and how many of them at most.
constexpr double kFlankStep = 0.05;
constexpr int kMostFlankSteps = 40;

}  // namespace

std::vector<Cylinder> cylinders_within(const Tool& tool) {
  if (tool.kind == ToolKind::kTSlot) return {};
  std::vector<Cylinder> cylinders{{0, tool.radius()}};
  if (tool.kind != ToolKind::kTapered || !has_flanks(tool)) return cylinders;
  const double wider = widest_radius(tool) - tool.radius();
  const int steps = std::clamp(static_cast<int>(std::ceil(wider / kFlankStep)), 1, kMostFlankSteps);
  for (int i = 1; i <= steps; ++i) {
    const double above = flank_height(tool) * i / steps;
    cylinders.push_back({above, radius_at(tool, above)});
  }
  return cylinders;
}

double height_of_edges(const Tool& tool) {
  return tool.kind == ToolKind::kTSlot ? tool.flute_length.value_or(HUGE_VAL) : HUGE_VAL;
}

}  // namespace clearcut::verify
