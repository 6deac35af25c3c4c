#include <vector>

#include "pipeline/resume/begin_again.h"
#include "pipeline/steps/section_order.h"

namespace clearcut::pipeline {
namespace {

/// mm. Material as near as that is touched; where a cutter comes down it is farther from all material than that.
constexpr double kTouches = 0.05, kFree = 0.2;
/// mm by which the way to the place may brush what stays: residuals between passes.
constexpr double kBrushes = 0.01;
/// Ways off, as shares of the radius, and degrees beside the direction straight off the material. The longest is taken that is free.
constexpr double kShares[] = {1, 0.5, 0.25};
constexpr double kTurns[] = {0, 30, -30, 60, -60, 90, -90};

}  // namespace

std::optional<Vec2> lead_place(const Part& part, const FirstPart& first, const Tool& tool, Vec2 place,
                               double z) {
  if (tool.kind != ToolKind::kEndMill) return std::nullopt;
  std::vector<double> radii;
  for (const Tool& one : part.tools) radii.push_back(one.radius() + kFree);
  stock::Material material = material_at_start(part, std::nullopt, radii);
  for (const Section& section : first.toolpath.sections)
    if (const Tool* const cut_by = tool_numbered(part.tools, section.tool_number))
      take_away(material, section, *cut_by);
  const double radius = tool.radius();
  const auto touched = material.circle_touch(place, radius + kTouches, z);
  if (!touched) return std::nullopt;
  for (const double share : kShares) {
    for (const double turn : kTurns) {
      const Vec2 beside = place - rotated(touched->toward, turn * kPi / 180) * (share * radius);
      if (material.in_reach(Edge::line(beside, beside), radius + kFree, z)) continue;
      if (!material.in_reach(Edge::line(beside, place), radius - kBrushes, z)) return beside;
    }
  }
  return std::nullopt;
}

}  // namespace clearcut::pipeline
