#include <fmt/format.h>

#include <algorithm>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "features/tool_choice.h"
#include "geometry/contours/boolean.h"
#include "resolve/features/shaping.h"

namespace clearcut::resolve {
namespace {

Radians taper_of(const Tool& tool) {
  return Radians::of(tool.tip_angle.value_or(Radians{}).radians() / 2);
}

std::string described(const Tool& tool) {
  return fmt::format("T{}, which tapers by {} degrees a side,", tool.number,
                     trimmed(taper_of(tool).degrees(), 3));
}

/// Throws for features without walls that may be inclined.
void refuse_without_walls(const Feature& feature, const Tool& tool) {
  const bool has_walls = !feature.profile && !feature.hole && !feature.chamfer && !feature.carving &&
                         feature.kind != FeatureKind::kIsolation;
  if (has_walls) return;
  throw InputError(feature.name,
                   described(tool) +
                       " mills pockets only; give an end mill for it, for example --tool endmill:" +
                       trimmed(tool.diameter, 4));
}

void refuse_among_upright_mills(const Part& part, const Workingstep& step) {
  for (const Workingstep& other : part.workplan) {
    const Tool& mill = tool_of(part, other);
    if (other.feature != step.feature || !mills_upright(mill)) continue;
    throw InputError(feature_of(part, step).name,
                     fmt::format("{} would cut into the walls that T{} leaves upright; mill it with one of "
                                 "them, or give the walls draft",
                                 described(tool_of(part, step)), mill.number));
  }
}

}  // namespace

bool meets_steeper_walls(const Part& part, const Feature& own, const Tool& tool, const Tolerances& tol) {
  if (tool.kind != ToolKind::kTapered) return false;
  return std::any_of(part.features.begin(), part.features.end(), [&](const Feature& other) {
    return &other != &own && other.floor_z < own.top_z && !features::keeps_walls(tool, other) &&
           box(other.target).overlaps(box(own.target)) && !intersect(other.target, own.target, tol).empty();
  });
}

void lean_walls(Part& part) {
  for (const Workingstep& step : part.workplan) {
    const Tool& tool = tool_of(part, step);
    if (tool.kind != ToolKind::kTapered) continue;
    Feature& feature = part.features[static_cast<std::size_t>(step.feature)];
    refuse_without_walls(feature, tool);
    if (feature.kind == FeatureKind::kPlanarFace || features::keeps_walls(tool, feature)) continue;
    refuse_among_upright_mills(part, step);
    const double drawn = base::tan(feature.wall_slope.radians());
    feature.wall_slope = taper_of(tool);
    const double stays = (feature.top_z - feature.floor_z) * (flank_slope(tool) - drawn);
    part.diagnostics.doubt(
        feature.name, "leaning-walls",
        fmt::format("{} leaves its walls leaning: {} mm more than drawn stay at their foot; "
                    "an end mill leaves them upright",
                    described(tool), trimmed(stays, 3)));
  }
}

}  // namespace clearcut::resolve
