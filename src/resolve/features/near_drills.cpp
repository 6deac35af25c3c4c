#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/text.h"
#include "features/round_hole.h"
#include "resolve/features/shaping.h"

namespace clearcut::resolve {
namespace {

/// Whether the hole is only stated to be round, or drilled.
bool is_plain_hole(const Feature& feature) {
  return feature.kind == FeatureKind::kRoundHole &&
         (!feature.hole || feature.hole->kind == HoleKind::kDrilled);
}

Regions disc(Vec2 center, double radius) {
  const Vec2 side{radius, 0};
  const auto half = [&](Vec2 from, Vec2 to) { return Edge::arc(from, to, center, Turn::kCounterClockwise); };
  return {
      Region::from_valid_loops({half(center + side, center - side), half(center - side, center + side)}, {})};
}

/// mm. The diameter of the nearest drill; 0 if none is near enough, or if a tool makes the hole at its exact size.
double near_drill(const features::RoundHole& hole, const std::vector<Tool>& tools, const Tolerances& tol) {
  const double wanted = 2 * hole.radius;
  double nearest = 0;
  for (const Tool& tool : tools) {
    const bool mills = clears_floors(tool) && tool.diameter <= wanted + tol.fit;
    if (mills || (makes_holes(tool) && features::makes_hole(tool, hole, tol))) return 0;
    if (tool.kind != ToolKind::kDrill || !features::is_near_size(tool.diameter, wanted)) continue;
    if (std::abs(tool.diameter - wanted) < std::abs(nearest - wanted)) nearest = tool.diameter;
  }
  return nearest;
}

void widen_to(Feature& feature, const features::RoundHole& hole, double diameter) {
  feature.target = feature.allowed = disc(hole.center, diameter / 2);
  if (feature.hole_diameter) feature.hole_diameter = diameter;
  if (feature.hole) feature.hole->diameter = diameter;
}

}  // namespace

void take_near_drills(Part& part, const PlanOptions& options) {
  struct Taken {
    std::string first;
    int count = 0;
  };
  std::map<std::pair<double, double>, Taken> taken;  // taken drills by the drawn and drilled diameters
  for (Feature& feature : part.features) {
    if (!is_plain_hole(feature)) continue;
    const auto hole = features::round_hole_of(feature, options.tol);
    const double drill = hole ? near_drill(*hole, options.tools, options.tol) : 0;
    if (drill <= 0) continue;
    Taken& one = taken[{2 * hole->radius, drill}];
    if (one.count++ == 0) one.first = feature.name;
    widen_to(feature, *hole, drill);
  }
  for (const auto& [diameters, one] : taken) {
    const auto& [drawn, drilled] = diameters;
    const std::string others = one.count > 1 ? "and " + std::to_string(one.count - 1) + " others: " : "";
    part.diagnostics.warn(one.first, others + trimmed(drawn, 4) + " mm wide, made by the drill of " +
                                         trimmed(drilled, 4) +
                                         " mm: " + trimmed(std::abs(drilled - drawn), 4) + " mm " +
                                         (drilled > drawn ? "wider" : "narrower") +
                                         ", and no tool at hand makes its size (drills are taken within " +
                                         trimmed(features::kNearDrill, 3) + " mm)");
  }
}

void allow_for_places_of_holes(Part& part, const Tolerances& tol) {
  std::vector<bool> plunged(part.features.size(), true);
  for (const Workingstep& step : part.workplan) {
    const Tool& tool = tool_of(part, step);
    if (!makes_holes(tool) && tool.kind != ToolKind::kTap)
      plunged[static_cast<std::size_t>(step.feature)] = false;
  }
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    Feature& feature = part.features[i];
    if (feature.kind != FeatureKind::kRoundHole || !plunged[i]) continue;
    if (const auto hole = features::round_hole_of(feature, tol))
      feature.allowed = disc(hole->center, hole->radius + kBesideLine);
  }
}

}  // namespace clearcut::resolve
