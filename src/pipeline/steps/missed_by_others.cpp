#include "pipeline/steps/missed_by_others.h"

#include "features/round_hole.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"
#include "model/cutter_profile.h"
#include "resolve/left_over.h"

namespace clearcut::pipeline {
namespace {

/// mm. The area assumed as reached is smaller by the first value than the real one; rests narrower than twice the
/// second are left out: more than the strip left along walls by the first.
constexpr double kSpare = 0.002;
constexpr double kSliver = 0.004;
/// mm. Overlap of the area planned for a rest with areas already cut.
constexpr double kOverlap = 0.05;

/// The area of its own feature cleared by a step's cutter down to z: the whole hole for holes made at once.
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
