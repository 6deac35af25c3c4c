#include "read/common/stock_edge.h"

#include "geometry/boolean.h"
#include "geometry/rectangle.h"

namespace clearcut::read {
namespace {

bool reaches_edge(const Feature& feature, const Box& stock, const Tolerances& tol) {
  const Box reach = box(feature.target), inner = stock.grown(-tol.join_gap / 2);
  return reach.overlaps(stock) && !(inner.contains(reach.min) && inner.contains(reach.max));
}

/// The target lies in `allowed`, so equal areas make them the same.
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

}  // namespace clearcut::read
