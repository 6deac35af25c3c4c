#include "read/drawing/stock_edge.h"

#include <algorithm>

#include "geometry/contours/boolean.h"
#include "geometry/rectangle.h"
#include "read/drawing/drawing.h"

namespace clearcut::read {
namespace {

/// Depth of a V-carving by the sharpest usual bit, 20 degrees, over its depth by one of 90 degrees, tan 45 / tan 10.
constexpr double kSharpest = 5.67;

/// mm; greatest depth of the feature after its cutter is chosen.
double lowest_of(const Feature& feature) {
  if (!feature.carving) return feature.floor_z;
  const double deepest = kSharpest * (feature.top_z - feature.floor_z);
  return feature.top_z - std::min(deepest, feature.carving->limit.value_or(deepest));
}

bool reaches_edge(const Feature& feature, const Box& stock, const Tolerances& tol) {
  const Box reach = box(feature.target), inner = stock.grown(-tol.join_gap / 2);
  return reach.overlaps(stock) && !(inner.contains(reach.min) && inner.contains(reach.max));
}

/// The target is inside `allowed`, so equal areas make them the same.
bool is_walled(const Feature& feature) {
  const double whole = area(feature.allowed);
  return whole - area(feature.target) <= 1e-9 * whole;
}

}  // namespace

void open_at_stock_edge(Part& part, const Tolerances& tol) {
  if (!part.stock) return;
  const Box& plan = part.stock->plan;
  const Region stock = rectangular_region(plan);
  const Region beside = frame_around(plan, kOpenReach);
  for (Feature& feature : part.features) {
    const bool is_area = !feature.profile && !feature.chamfer && !feature.hole_diameter && is_walled(feature);
    if (!is_area || !reaches_edge(feature, plan, tol)) continue;
    feature.allowed = unite(feature.allowed, {beside}, tol);
    feature.target = intersect(feature.target, {stock}, tol);
    if (feature.kind == FeatureKind::kClosedPocket) feature.kind = FeatureKind::kOpenPocket;
  }
}

void set_stock(Part& part, const std::vector<ShapedGroup>& groups, const std::vector<Feature>& features,
               const ReadOptions& options) {
  for (const ShapedGroup& shaped : groups) {
    if (shaped.group.role != LayerRole::kStock || shaped.regions.empty()) continue;
    Stock stock;
    stock.plan = box(shaped.regions);
    stock.z_top = options.top ? *options.top : shaped.group.top.value_or(0);
    stock.z_bottom = features.front().floor_z;
    for (const Feature& feature : features) stock.z_bottom = std::min(stock.z_bottom, lowest_of(feature));
    if (shaped.group.depth)
      stock.z_bottom = stock.z_top - checked_depth(*shaped.group.depth, shaped.group.where);
    part.stock = stock;
  }
}

}  // namespace clearcut::read
