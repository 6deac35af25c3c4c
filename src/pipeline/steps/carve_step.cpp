#include "pipeline/steps/carve_step.h"

#include <algorithm>
#include <cmath>

#include "geometry/boolean.h"
#include "geometry/clearance.h"
#include "link/tracks/tracks.h"
#include "pipeline/certify.h"
#include "plan/carve/carve.h"
#include "post/post.h"

namespace clearcut::pipeline {
namespace {

/// mm. Ridges that a pointed bit may leave on a floor where no mill reaches; less than the certificate allows.
constexpr double kCusp = 0.03;
/// mm. What chords of the medial axis take of the flanks' distance from the outline.
constexpr double kChords = 0.0004;

/// What the coarser of millimetres and inches moves a tip sideways.
double rounding(const ResolvedPlan& plan) {
  PostOptions metric = plan.post, inch = plan.post;
  metric.inch = false;
  inch.inch = true;
  return plan.post.decimals ? post::rounding_of(plan.post)
                            : std::max(post::rounding_of(metric), post::rounding_of(inch));
}

/// What the mills of earlier steps clear of the floor of a V-carving.
Regions cleared_before(int workingstep, const Region& region, const ResolvedPlan& plan) {
  const Part& part = plan.part;
  const Workingstep& own = part.workplan[static_cast<std::size_t>(workingstep)];
  const Feature& feature = feature_of(part, own);
  const double foot = (feature.top_z - feature.floor_z) * std::tan(feature.wall_slope.radians());
  Regions cleared;
  for (int i = 0; i < workingstep; ++i) {
    const Workingstep& step = part.workplan[static_cast<std::size_t>(i)];
    if (step.feature != own.feature || !clears_floors(tool_of(part, step))) continue;
    const double radius = tool_of(part, step).radius(), flat = radius - tool_of(part, step).corner_radius;
    const Regions centers = inset(region, foot + radius + step.operation.allowance_side, plan.tol);
    if (!centers.empty()) cleared = unite(cleared, dilate(centers, flat, plan.tol), plan.tol);
  }
  return cleared;
}

plan::carve::TrackSets tracks_of(int workingstep, const ResolvedPlan& plan) {
  const Workingstep& step = plan.part.workplan[static_cast<std::size_t>(workingstep)];
  const Feature& feature = feature_of(plan.part, step);
  const Tool& tool = tool_of(plan.part, step);
  const double stepdown = plan.steps[static_cast<std::size_t>(workingstep)].stepdown;
  if (feature.profile)
    return plan::carve::engrave_line(feature.profile->line, feature.profile->closed, feature.top_z,
                                     feature.floor_z, stepdown);
  plan::carve::CarveShape shape;
  shape.top = feature.top_z;
  shape.floor = feature.floor_z;
  shape.slope = flank_slope(tool);
  shape.tip_radius = tool.tip_diameter / 2;
  shape.aside = kChords + std::max(0.0, rounding(plan) * (1 + shape.slope) - plan.tol.gouge / 2);
  shape.stepdown = stepdown;
  shape.cusp = kCusp;
  plan::carve::TrackSets sets;
  for (const Region& region : feature.target) {
    for (auto& set :
         plan::carve::carve_region(region, shape, cleared_before(workingstep, region, plan), plan.tol))
      sets.push_back(std::move(set));
  }
  return sets;
}

}  // namespace

std::optional<Section> carve_step(int workingstep, const ResolvedPlan& plan) {
  const Workingstep& step = plan.part.workplan[static_cast<std::size_t>(workingstep)];
  if (!is_carved(feature_of(plan.part, step), tool_of(plan.part, step))) return std::nullopt;
  const link::LinkOptions link =
      link_options(plan, workingstep, plan.steps[static_cast<std::size_t>(workingstep)].entry);
  Section section =
      link::link_tracks(tracks_of(workingstep, plan), plan.part.top_z() + link.above_material, link);
  describe(section, workingstep, plan);
  return section;
}

}  // namespace clearcut::pipeline
