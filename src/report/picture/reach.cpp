#include "report/picture/reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "features/at_depth.h"
#include "geometry/voronoi/clearance.h"
#include "report/picture/job_view.h"

namespace clearcut::report {

namespace {

const Tolerances kTolerances;

/// The least stock left on walls by any operation on the feature: the stock of finishing if there is any.
double wall_stock(const Part& part, int feature) {
  double least = std::numeric_limits<double>::infinity();
  for (const Workingstep& step : part.workplan) {
    if (step.feature == feature) least = std::min(least, step.operation.allowance_side);
  }
  return std::isfinite(least) ? std::max(least, 0.0) : 0;
}

const Tool* smaller(const Tool* tool, const Tool& other) {
  if (!(other.diameter > 0)) return tool;
  return tool && tool->diameter <= other.diameter ? tool : &other;
}

/// The smallest cutter that worked on the feature, or else was planned for it; null if there is none.
const Tool* smallest_cutter(const Job& job, int feature) {
  const Tool *worked = nullptr, *meant = nullptr;
  for (const Section& section : job.toolpath.sections) {
    const Tool* tool = tool_of(job.part, section);
    if (tool != nullptr && feature_of(job.part, section) == feature) worked = smaller(worked, *tool);
  }
  for (const Workingstep& step : job.part.workplan) {
    const auto tool = static_cast<std::size_t>(step.operation.tool);
    if (step.feature == feature && tool < job.part.tools.size()) meant = smaller(meant, job.part.tools[tool]);
  }
  return worked ? worked : meant;
}

Regions at_floor(const Regions& regions, const Feature& feature) {
  if (!(feature.wall_slope.radians() > 0)) return regions;
  return features::at_depth(regions, feature.wall_slope, feature.top_z - feature.floor_z, kTolerances);
}

}  // namespace

Regions floor_target(const Feature& feature) {
  return at_floor(feature.target, feature);
}
Regions floor_allowed(const Feature& feature) {
  return at_floor(feature.allowed, feature);
}

double width_on_floor(const Feature& feature, const Tool& tool, double above) {
  const bool is_hole = feature.kind == FeatureKind::kRoundHole || feature.hole;
  return is_hole && tool.kind == ToolKind::kDrill ? tool.diameter : 2 * radius_at(tool, above);
}

Reach reach_of(const Job& job, int feature) {
  Reach reach;
  const Tool* const cutter = smallest_cutter(job, feature);
  if (!cutter) return reach;
  reach.diameter = cutter->diameter;
  reach.flat = width_on_floor(job.part.features[static_cast<std::size_t>(feature)], *cutter, 0);
  const double distance = reach.diameter / 2 + wall_stock(job.part, feature);
  for (const Region& region : floor_allowed(job.part.features[static_cast<std::size_t>(feature)])) {
    const Clearance clearance(region, kTolerances);
    for (Region& piece : clearance.inset(distance)) reach.centers.push_back(std::move(piece));
    for (Path& line : clearance.fit_lines(distance)) reach.fit_lines.push_back(std::move(line));
    for (const AxisPoint& center : clearance.centers()) {
      if (std::abs(center.clearance - distance) <= kTolerances.fit) reach.fit_points.push_back(center.point);
    }
  }
  return reach;
}

}  // namespace clearcut::report
