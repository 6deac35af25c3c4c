#include "plan/common/layers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "features/derived_outlines.h"
#include "geometry/contours/boolean.h"
#include "plan/common/round_on_wall.h"

namespace clearcut::plan {
namespace {

/// Share of the stepdown. A last layer thinner than this would rub rather than cut.
constexpr double kSliver = 0.05;
/// A stepdown requiring more layers than this is taken as a typing mistake.
constexpr double kMostLayers = 10000;
/// Relative. Rounding of decimal depths: 10.1 - 0.1 are ten steps of 1.
constexpr double kRounding = 1e-9;

/// mm; the height that a layer may take on leaning walls, of a rounded end that touches them, or keeps off as if it were flat.
double height_for(double scallop, double draft, const RoundedEnd& end) {
  const double flat = scallop / base::sin(draft);
  if (end.round <= 0) return flat;
  const RoundOnWall touch{end.round, draft};
  return end.touches_walls ? touch.height_within(scallop) : touch.height_kept_off(scallop).value_or(flat);
}

/// mm; no more than leaves the scallop on leaning walls.
double step_for(const Feature& feature, const Operation& operation, double tool_radius,
                const RoundedEnd& end) {
  const double step = operation.stepdown.value_or(tool_radius), draft = feature.wall_slope.radians();
  if (!operation.scallop || *operation.scallop <= 0 || draft <= 0) return step;
  return std::min(step, height_for(*operation.scallop, draft, end));
}

Layer outline_at(const Feature& feature, double z, const Tolerances& tol) {
  Layer layer;
  layer.z = z;
  if (feature.wall_slope.radians() == 0) {
    layer.target = feature.target;
    layer.allowed = feature.allowed;
    return layer;
  }
  layer.allowed = features::at_depth(feature.allowed, feature.wall_slope, feature.top_z - z, tol);
  // Open sides have no draft: only the walls, bounding `allowed`, move inwards with depth.
  layer.target = closed_all_round(feature) ? layer.allowed : intersect(feature.target, layer.allowed, tol);
  return layer;
}

/// mm; radius of a ball end at the top of a feature that is less deep than the ball: what its passes leave between them stands up to
/// the top.
double radius_at_top(double ball, double depth) {
  return depth >= ball ? ball : std::sqrt(std::max(0.0, depth * (2 * ball - depth)));
}

/// Whether passes planned for one of these layers can be used in the other, at its own depth.
bool same_areas(const Layer& a, const Layer& b) {
  return a.tool_radius == b.tool_radius && a.wall_stock == b.wall_stock && a.reserve == b.reserve &&
         a.bare == b.bare && same_outline(a.allowed, b.allowed) && same_outline(a.target, b.target);
}

/// Heights in steps of at most `step`, as many of them as can be from `others`: the lowest within a step, and where there is none the
/// way to the next one is divided.
std::vector<double> heights_among(const std::vector<double>& others, double top, double floor_z,
                                  double step) {
  std::vector<double> heights;
  const auto go_down_to = [&](double z) {
    const double from = heights.empty() ? top : heights.back();
    if (from - z <= kSamePlaceMm) return;
    for (const double between : layer_heights(from, z, step)) heights.push_back(between);
  };
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (others[i] <= floor_z + kSamePlaceMm) break;
    const double from = heights.empty() ? top : heights.back();
    const double next = i + 1 < others.size() ? std::max(others[i + 1], floor_z) : floor_z;
    if (from - next > step + kSamePlaceMm) go_down_to(others[i]);
  }
  go_down_to(floor_z);
  return heights;
}

/// Adds the height at which an end sharper than the fillet at the foot of leaning walls is beside the wall for the last time: lower layers
/// keep off the fillet.
void add_height_over_fillet(std::vector<double>& heights, const Feature& feature, double round) {
  const double draft = feature.wall_slope.radians(), sharper = feature.floor_fillet - round;
  if (draft <= 0 || sharper <= 0) return;
  const double z = feature.floor_z + sharper * (1 - base::sin(draft));
  if (z >= feature.top_z) return;
  const auto next =
      std::lower_bound(heights.begin(), heights.end(), z + kSamePlaceMm, std::greater<double>());
  if (next == heights.end() || z - *next > kSamePlaceMm) heights.insert(next, z);
}

}  // namespace

std::vector<double> layer_heights(double top_z, double floor_z, double stepdown) {
  if (!(stepdown > 0)) throw InputError("stepdown", "must be above 0 mm");
  const double depth = top_z - floor_z;
  if (!(depth > kRounding)) return {};
  const double steps = depth / stepdown;
  if (steps > kMostLayers) {
    throw InputError("stepdown", trimmed(stepdown, 6) + " mm would need over 10 000 layers for a depth of " +
                                     trimmed(depth, 3) + " mm; use a larger one");
  }
  const int count = std::max(1, static_cast<int>(std::ceil(steps - kRounding)));
  const double rest = steps - (count - 1);
  const bool equal = count > 1 && rest < kSliver;
  std::vector<double> heights;
  for (int i = 1; i < count; ++i) heights.push_back(top_z - (equal ? depth * i / count : stepdown * i));
  heights.push_back(floor_z);
  return heights;
}

std::vector<double> heights_of(const Feature& feature, const Operation& operation, double tool_radius,
                               const RoundedEnd& end, double top, const std::vector<double>& others) {
  const double floor_z = feature.floor_z + operation.allowance_floor;
  const double step = step_for(feature, operation, tool_radius, end);
  std::vector<double> heights =
      others.empty() ? layer_heights(top, floor_z, step) : heights_among(others, top, floor_z, step);
  add_height_over_fillet(heights, feature, end.round);
  return heights;
}

std::vector<Layer> layers_of(const Feature& feature, const Operation& operation, double tool_radius,
                             const Tolerances& tol, const RoundedEnd& end, double stock_above,
                             const std::vector<double>& others) {
  const double draft = feature.wall_slope.radians();
  const bool is_ball = end.round >= tool_radius, is_near = end.touches_walls && draft > 0 && end.round > 0;
  const double beside = is_near ? RoundOnWall{end.round, draft}.beside() : end.round;
  const double floor_z = feature.floor_z + operation.allowance_floor;
  const double cleared =
      is_ball ? std::min(beside, radius_at_top(end.round, feature.top_z - floor_z)) : tool_radius - end.round;
  const double rounded = is_ball ? beside - cleared : end.round;
  std::vector<Layer> layers;
  double top = feature.top_z + stock_above;
  for (const double z : heights_of(feature, operation, tool_radius, end, top, others)) {
    Layer layer = outline_at(feature, z, tol);
    layer.z_top = top;
    layer.tool_radius = cleared;
    layer.wall_stock = operation.allowance_side + (is_ball ? rounded : beside);
    layer.rounded = rounded;
    top = z;
    if (!layer.target.empty() && !layer.allowed.empty()) layers.push_back(std::move(layer));
  }
  return layers;
}

bool same_outline(const Regions& a, const Regions& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Region& r, const Region& s) {
    return r.outer() == s.outer() && r.islands() == s.islands();
  });
}

Strategy once_per_outline(Strategy plan) {
  return [plan = std::move(plan), last = std::optional<Layer>(),
          passes = LayerPasses()](const Layer& layer) mutable {
    if (!last || !same_areas(*last, layer)) passes = plan(layer);
    last = layer;
    passes.z_top = layer.z_top;
    passes.z = layer.z;
    return passes;
  };
}

}  // namespace clearcut::plan
