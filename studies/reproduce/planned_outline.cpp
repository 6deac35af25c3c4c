#include "studies/reproduce/planned_outline.h"

#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::studies {

Part pocket_part(const Region& outline, const std::string& name, double diameter) {
  Part part;
  part.name = name;
  Tool tool;
  tool.diameter = diameter;
  part.tools = {tool};
  Feature feature;
  feature.name = name;
  feature.target = feature.allowed = {outline};
  feature.floor_z = -1;
  part.features = {feature};
  Workingstep step;
  step.operation.stepdown = 1;
  step.operation.entry = EntryKind::kPlunge;
  part.workplan = {step};
  return part;
}

std::optional<PlanResult> planned_outline(const Part& part, const OutlineMethod& method) {
  PlanOptions options;
  options.strategy = method.strategy;
  options.stepover = method.stepover;
  options.post.decimals = method.decimals;
  options.published.sharp_reflex = options.published.bisector_passages = method.as_printed;
  try {
    return pipeline::plan_part(part, options);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

Region outline_of(const SideList& list) {
  return Region::from_valid_loops(closed_by_compass_rule(traced(list)), {});
}

Region equilateral(double edge) {
  const std::vector<Vec2> corners{{0, 0}, {edge, 0}, {edge / 2, edge * std::sqrt(3.0) / 2}};
  return Region::from_valid_loops(loop_from_points(corners), {});
}

Region star(int tips, double side, double tip) {
  SideList list;
  for (int i = 0; i < tips; ++i) {
    list.sides.push_back({side, Radians::of_degrees(360.0 * (tips - 1) / tips - tip).radians(), 0});
    list.sides.push_back({side, Radians::of_degrees(tip).radians(), 0});
  }
  return outline_of(list);
}

Region scaled(const std::vector<Vec2>& corners, double factor) {
  std::vector<Vec2> points;
  for (const Vec2 corner : corners) points.push_back(corner * factor);
  return Region::from_valid_loops(loop_from_points(points), {});
}

Region inscribed_polygon(const Tolerances& tol) {
  const std::vector<Vec2> corners{{0, 0}, {91.8, 0}, {99.1, 25.6}, {91.5, 91.5 * base::tan(kPi / 6)}};
  return scaled(corners, kInscribed / Clearance(scaled(corners, 1), tol).max());
}

}  // namespace clearcut::studies
