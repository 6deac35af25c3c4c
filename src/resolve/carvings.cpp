#include "resolve/carvings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text/format.h"
#include "features/fitting.h"
#include "features/kerf.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"
#include "resolve/prepare.h"
#include "resolve/values/tool_cutting.h"

namespace clearcut::resolve {
namespace {

/// mm. Permitted deviation of the flanks in an engraved line from its groove.
constexpr double kBesideGroove = 0.0005;
/// mm. Floors narrower than this beyond the mill's diameter are left to the bit.
constexpr double kRoom = 0.01;

double widest_clearance(const Regions& regions, const Tolerances& tol) {
  double widest = 0;
  for (const Region& region : regions) widest = std::max(widest, Clearance(region, tol).max());
  return widest;
}

/// Largest fitting mill that clears floors; -1 for none.
int floor_mill(const Feature& feature, const std::vector<Tool>& tools, const Tolerances& tol) {
  const double fits = features::largest_fitting_diameter(feature, tol) - kRoom;
  int best = -1;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const bool flat = mills_upright(tools[i]) && tools[i].kind != ToolKind::kBallEndMill;
    if (!flat || tools[i].diameter > fits) continue;
    if (best < 0 || tools[i].diameter > tools[static_cast<std::size_t>(best)].diameter)
      best = static_cast<int>(i);
  }
  return best;
}

bool has_mill(const std::vector<Tool>& tools) {
  return std::any_of(tools.begin(), tools.end(), [](const Tool& tool) { return mills_upright(tool); });
}

std::string size_of(const Tool& bit) {
  return fmt::format("T{} ({} {} deg, {} mm)", bit.number, name_of(bit.kind),
                     trimmed(bit.tip_angle->degrees(), 3), trimmed(bit.diameter, 4));
}

[[noreturn]] void refuse_without_mill(const Feature& feature, const Tool& bit, double widest) {
  throw InputError(
      feature.name,
      fmt::format("it is up to {} mm wide and {} reaches its walls down to {} mm: the floor between them "
                  "needs an end mill; give one besides, for example --tool endmill:3{}",
                  trimmed(2 * widest, 3), size_of(bit), trimmed(feature.top_z - feature.floor_z, 3),
                  feature.carving->limit ? ", or allow more depth" : ", or a wider bit"));
}

/// Depth of the bit in the feature: down to its limit, to the bit's full width, or to the depth required by the
/// widest place.
double depth_of(const Feature& feature, const Tool& bit, double widest) {
  const double asked = (widest - bit.tip_diameter / 2) / flank_slope(bit);
  return std::min({asked, flank_height(bit), feature.carving->limit.value_or(asked)});
}

void shape_carving(Feature& feature, const Tool& bit, double widest) {
  if (widest <= bit.tip_diameter / 2) {
    throw InputError(feature.name, fmt::format("the tip of {} is {} mm wide and fits nowhere into it; use a "
                                               "bit with a smaller tip",
                                               size_of(bit), trimmed(bit.tip_diameter, 4)));
  }
  feature.wall_slope = Radians::of(bit.tip_angle->radians() / 2);
  feature.floor_z = feature.top_z - depth_of(feature, bit, widest);
}

/// A plug for an inlay: its outline is as drawn at `start` below the top, so that its walls, inclined outwards, are
/// farther in at the top. At the border of the carved area, the area is not widened beyond the permitted area.
void widen_to_start(Feature& feature, const Tool& bit, const Tolerances& tol) {
  const double start = feature.carving->start;
  if (start <= 0) return;
  if (feature.carving->limit && *feature.carving->limit <= start)
    throw InputError(
        feature.name,
        fmt::format("it is carved {} mm deep and its outline is as drawn at {} mm: carve deeper, "
                    "as in VCARVE_START1_D2.5",
                    trimmed(*feature.carving->limit, 3), trimmed(start, 3)));
  feature.target = feature.allowed = dilate(feature.target, start * flank_slope(bit), tol);
}

Workingstep floor_step(const Workingstep& step, int mill, const Part& part, const PlanOptions& options,
                       StepSources& sources) {
  Workingstep out = step;
  out.stated_path.reset();
  out.name += "_floor";
  out.operation.name = out.name;
  sources[step_key(out)] = sources[step_key(step)];
  change_tool(out.operation, mill, part, options);
  return out;
}

/// Gives the feature the groove of a shaped cutter along a line.
void shape_groove(Feature& feature, const Tool& tool) {
  const double depth = feature.top_z - feature.floor_z;
  if (is_conical(tool) && depth > flank_height(tool)) {
    throw InputError(feature.name,
                     fmt::format("it is {} mm deep and the flanks of {} end {} mm above its tip; "
                                 "use less depth or a wider bit",
                                 trimmed(depth, 3), size_of(tool), trimmed(flank_height(tool), 3)));
  }
  const double radius = radius_at(tool, depth);
  const Tolerances tol;
  feature.target = features::kerf_of(*feature.profile, 2 * radius, tol);
  feature.allowed = features::kerf_of(*feature.profile, 2 * (radius + kBesideGroove), tol);
  if (is_conical(tool)) feature.wall_slope = Radians::of(tool.tip_angle->radians() / 2);
}

}  // namespace

void shape_carvings(Part& part, const PlanOptions& options, StepSources& sources) {
  std::vector<Workingstep> workplan;
  for (const Workingstep& step : part.workplan) {
    Feature& feature = part.features[static_cast<std::size_t>(step.feature)];
    const Tool& tool = tool_of(part, step);
    if (feature.carving && !is_conical(tool))
      throw InputError(feature.name, "V-carving needs a V-bit; give one, for example --tool vbit:60deg:6");
    if (feature.carving) {
      widen_to_start(feature, tool, options.tol);
      const double widest = widest_clearance(feature.target, options.tol);
      shape_carving(feature, tool, widest);
      const double floor_from = tool.tip_diameter / 2 + (feature.top_z - feature.floor_z) * flank_slope(tool);
      if (widest > floor_from + options.tol.fit) {
        if (!has_mill(part.tools)) refuse_without_mill(feature, tool, widest);
        const int mill = floor_mill(feature, part.tools, options.tol);
        if (mill >= 0) workplan.push_back(floor_step(step, mill, part, options, sources));
      }
    } else if (!feature.chamfer && is_carved(feature, tool)) {
      shape_groove(feature, tool);
    }
    workplan.push_back(step);
  }
  part.workplan = std::move(workplan);
}

}  // namespace clearcut::resolve
