#include "pipeline/steps/missed_by_others.h"

#include "features/round_hole.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"
#include "model/cutter_profile.h"
#include "resolve/left_over.h"

namespace clearcut::pipeline {
namespace {

/// mm. What is taken to be reached stays this far inside of what is; what is narrower than twice the second is left out, more
/// than the strip that the first leaves along walls.
constexpr double kSpare = 0.002;
constexpr double kSliver = 0.004;
/// mm. How far what is planned for a rest reaches over what is cut already.
constexpr double kOverlap = 0.05;

/// What a step's cutter clears of its own feature down to z: all of a hole that is made at once.
Regions reached_by(const Part& part, const Workingstep& step, double z, const Tolerances& tol) {
  const Feature& feature = feature_of(part, step);
  const Tool& tool = tool_of(part, step);
  const double tip = feature.floor_z + step.operation.allowance_floor;
  const bool reaches = tip <= z + tol.coincident && step.operation.kind != OperationKind::kSideFinishing &&
                       !feature.chamfer && feature.kind != FeatureKind::kTSlot && !is_formed(feature);
  if (!reaches) return {};
  if (makes_holes(tool))
    return features::full_depth(part, step) <= z + tol.coincident ? feature.target : Regions{};
  const double narrower = std::max(0.0, tool.radius() - radius_cleared(tool, z - tip));
  return resolve::swept(feature.allowed, tool.radius(), step.operation.allowance_side, -kSpare - narrower,
                        tol);
}

}  // namespace

Regions missed_by_others(int workingstep, const Layer& layer, const ResolvedPlan& plan) {
  const Part& part = plan.part;
  const Tolerances& tol = plan.tol;
  const Box here = box(layer.target);
  Regions left = layer.target;
  for (int i = 0; i < workingstep && !left.empty(); ++i) {
    const Workingstep& step = part.workplan[static_cast<std::size_t>(i)];
    const Feature& other = feature_of(part, step);
    if (!box(other.target).overlaps(here)) continue;
    if (other.wall_slope.radians() != 0) return {};
    left = subtract(left, reached_by(part, step, layer.z, tol), tol);
  }
  if (left.empty()) return left;
  left =
      intersect(left, resolve::swept(layer.allowed, layer.tool_radius, layer.wall_stock, -kSpare, tol), tol);
  const Regions thick = inset(left, kSliver, tol);
  if (thick.empty()) return thick;
  return intersect(dilate(thick, kSliver + kOverlap + 1.5 * layer.wall_stock, tol), layer.target, tol);
}

}  // namespace clearcut::pipeline
