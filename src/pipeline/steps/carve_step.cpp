#include "pipeline/steps/carve_step.h"

#include <algorithm>
#include <set>

#include "base/elementary.h"
#include "geometry/contours/boolean.h"
#include "geometry/rectangle.h"
#include "geometry/voronoi/clearance.h"
#include "link/tracks/tracks.h"
#include "pipeline/steps/certify.h"
#include "plan/carve/carve.h"
#include "plan/carve/chamfer.h"
#include "post/post.h"

namespace clearcut::pipeline {
namespace {

/// mm. Ridges that a pointed bit may leave on a floor out of reach of mills; less than the certificate allows.
constexpr double kCusp = 0.03;
/// mm. Reduction of the flanks' distance from the outline by chords of the medial axis.
constexpr double kChords = 0.0004;
/// mm. Reduction of the distance from a wall by offsets and booleans.
constexpr double kOffsets = 0.001;

/// The part of a V-carving's floor cleared by the mills of earlier steps.
Regions cleared_before(int workingstep, const Region& region, const ResolvedPlan& plan) {
  const Part& part = plan.part;
  const Workingstep& own = part.workplan[static_cast<std::size_t>(workingstep)];
  const Feature& feature = feature_of(part, own);
  const double foot = (feature.top_z - feature.floor_z) * base::tan(feature.wall_slope.radians());
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

/// mm; distance of a flank from material not to be cut if tips are printed to `rounding`. Kept minimal: in sharp
/// corners several times this distance is left.
double aside_of(double slope, double rounding, const ResolvedPlan& plan) {
  return kChords + std::max(0.0, rounding * (1 + slope) - 0.9 * plan.tol.gouge);
}

/// The free area up to every height at which material ends, from the top of a chamfer on.
std::vector<plan::carve::StandingUpTo> standing_above(const Feature& feature, const ResolvedPlan& plan) {
  const Part& part = plan.part;
  std::set<double> heights{feature.top_z, part.top_z()};
  for (const Feature& other : part.features) heights.insert(other.top_z);
  std::vector<plan::carve::StandingUpTo> out;
  for (const double z : heights) {
    if (z < feature.top_z) continue;
    Regions free;
    if (part.stock) {
      const Box& block = part.stock->plan;
      free = {frame_around(block, kOpenReach)};
    }
    for (const Feature& other : part.features) {
      if (other.floor_z < z && other.kind != FeatureKind::kTSlot && !other.allowed.empty())
        free = free.empty() ? other.allowed : unite(free, other.allowed, plan.tol);
    }
    out.push_back({z, std::move(free)});
  }
  return out;
}

plan::carve::TrackSets chamfer_tracks(const Feature& feature, const Tool& tool, double stepdown,
                                      const ResolvedPlan& plan) {
  plan::carve::ChamferShape shape;
  shape.top = feature.top_z;
  shape.slope = flank_slope(tool);
  shape.tip_radius = tool.tip_diameter / 2;
  shape.tool_radius = tool.radius();
  shape.aside = kOffsets + aside_of(shape.slope, post::rounding_of(plan.post), plan);
  shape.stepdown = stepdown;
  return plan::carve::chamfer_edge(*feature.chamfer, shape, standing_above(feature, plan), plan.tol).sets;
}

plan::carve::CarveShape carve_shape(const Feature& feature, const Tool& tool, double stepdown,
                                    const ResolvedPlan& plan) {
  plan::carve::CarveShape shape;
  shape.top = feature.top_z;
  shape.floor = feature.floor_z;
  shape.slope = flank_slope(tool);
  shape.tip_radius = tool.tip_diameter / 2;
  shape.aside = aside_of(shape.slope, post::rounding_of_lines(plan.post), plan);
  shape.arcs_aside = aside_of(shape.slope, post::rounding_of(plan.post), plan) - shape.aside;
  shape.stepdown = stepdown;
  shape.cusp = kCusp;
  return shape;
}

/// mm. Rounding of distances between a straight move and an outline at the least permitted distance.
constexpr double kRounding = 1e-7;

/// A straight move is free if the cone, with its tip at that height, fits between the outlines along the whole move.
/// Below the first pass the move must be short: at its beginning the cone has cut all material except that of one
/// pass.
link::TipRoom room_within(const Regions& target, const plan::carve::CarveShape& shape) {
  const auto holds = [&target, shape](Vec2 from, Vec2 to, double z) {
    const double needed = shape.tip_radius + shape.aside + (shape.top - z) * shape.slope - kRounding;
    const Edge way = Edge::line(from, to);
    return std::any_of(target.begin(), target.end(), [&](const Region& region) {
      const auto edges = region.edges();
      return region.contains(from) && std::all_of(edges.begin(), edges.end(), [&](const Edge& edge) {
               return distance(edge, way) >= needed;
             });
    });
  };
  return {holds, shape.top - shape.stepdown, shape.tip_radius + shape.stepdown * shape.slope};
}

/// The tracks of the tip, and the room for crossing from one track to the next.
struct Tracks {
  plan::carve::TrackSets sets;
  link::TipRoom room;
};

Tracks tracks_of(int workingstep, const ResolvedPlan& plan) {
  const Workingstep& step = plan.part.workplan[static_cast<std::size_t>(workingstep)];
  const Feature& feature = feature_of(plan.part, step);
  const Tool& tool = tool_of(plan.part, step);
  const double stepdown = plan.steps[static_cast<std::size_t>(workingstep)].stepdown;
  if (feature.chamfer) return {chamfer_tracks(feature, tool, stepdown, plan), {}};
  if (feature.profile)
    return {plan::carve::engrave_line(feature.profile->line, feature.profile->closed, feature.top_z,
                                      feature.floor_z, stepdown),
            {}};
  const auto shape = carve_shape(feature, tool, stepdown, plan);
  Tracks tracks;
  for (const Region& region : feature.target) {
    for (auto& set :
         plan::carve::carve_region(region, shape, cleared_before(workingstep, region, plan), plan.tol))
      tracks.sets.push_back(std::move(set));
  }
  tracks.room = room_within(feature.target, shape);
  return tracks;
}

}  // namespace

std::optional<Section> carve_step(int workingstep, const ResolvedPlan& plan) {
  const Workingstep& step = plan.part.workplan[static_cast<std::size_t>(workingstep)];
  if (!is_carved(feature_of(plan.part, step), tool_of(plan.part, step))) return std::nullopt;
  const link::LinkOptions link =
      link_options(plan, workingstep, plan.steps[static_cast<std::size_t>(workingstep)].entry);
  Tracks tracks = tracks_of(workingstep, plan);
  Section section =
      link::link_tracks(std::move(tracks.sets), plan.part.top_z() + link.above_material, link, tracks.room);
  describe(section, workingstep, plan);
  return section;
}

}  // namespace clearcut::pipeline
