#include "pipeline/meeting_pockets.h"

#include <algorithm>
#include <optional>

#include "geometry/boolean.h"
#include "geometry/clearance.h"
#include "pipeline/left_over.h"

namespace clearcut {
namespace {

/// mm. Outlines that are no farther apart touch; what reaches no farther beyond an outline does not count.
constexpr double kTouching = 0.005;

bool is_bounded_by_itself(const Feature& feature) {
  return feature.kind != FeatureKind::kClosedPocket;
}

bool runs_into(const Feature& other, const Regions& around, const Tolerances& tol) {
  return !intersect(other.allowed, around, tol).empty() && !subtract(other.allowed, around, tol).empty();
}

}  // namespace

std::vector<const Feature*> features_meeting(const Part& part, int workingstep, const Tolerances& tol) {
  std::vector<const Feature*> met;
  const Feature& pocket = feature_of(part, part.workplan[static_cast<std::size_t>(workingstep)]);
  if (is_bounded_by_itself(pocket)) return met;
  const Box here = box(pocket.target).grown(kTouching);
  std::optional<Regions> around;  // made for the first that asks: most pockets lie alone
  for (int i = 0; i < static_cast<int>(part.workplan.size()); ++i) {
    const Feature* other = &feature_of(part, part.workplan[static_cast<std::size_t>(i)]);
    const bool open_to_layers =
        other->floor_z < pocket.top_z && (i < workingstep || other->top_z <= pocket.top_z);
    if (other == &pocket || !open_to_layers || !box(other->allowed).overlaps(here)) continue;
    if (std::find(met.begin(), met.end(), other) != met.end()) continue;
    if (!around) around = dilate(pocket.target, kTouching, tol);
    if (runs_into(*other, *around, tol)) met.push_back(other);
  }
  return met;
}

void widen_where_met(Layer& layer, const std::vector<const Feature*>& met, const Tolerances& tol) {
  Regions wide = layer.allowed;
  bool is_open = false;
  for (const Feature* other : met) {
    if (other->floor_z > layer.z) continue;
    wide = unite(wide, at_depth(other->allowed, other->wall_slope, other->top_z - layer.z, tol), tol);
    is_open = true;
  }
  if (!is_open) return;
  const double around = 2 * (layer.tool_radius + layer.wall_stock);
  const Regions near = dilate(layer.allowed, around, tol);
  const auto reached = [&](const Regions& allowed, double more) {
    return swept(allowed, layer.tool_radius, layer.wall_stock, more, tol);
  };
  const Regions with_others = intersect(layer.target, reached(intersect(wide, near, tol), 0), tol);
  // A little more than by itself, or the two leave slivers all along where they are the same.
  const Regions gained = subtract(with_others, reached(layer.allowed, tol.uncut / 2), tol);
  if (gained.empty()) return;
  const Regions beside = dilate(gained, around, tol);
  layer.target = layer.allowed = unite(layer.allowed, intersect(wide, beside, tol), tol);
}

}  // namespace clearcut
