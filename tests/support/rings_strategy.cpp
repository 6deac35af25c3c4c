#include "support/rings_strategy.h"

#include "base/error.h"
#include "geometry/voronoi/clearance.h"
#include "plan/common/clearing_area.h"
#include "plan/common/layers.h"

namespace clearcut::test_support::rings {
namespace {

/// Of the radius. Leaves nothing in corners of 29 degrees and more.
constexpr double kStep = 0.5;

/// Adds the contours inside `region`, each with the pass that surrounds it as parent.
void add_rings(const Region& region, int parent, int component, double step, const Tolerances& tol,
               LayerPasses& layer) {
  for (const Region& ring : inset(region, step, tol)) {
    const int outer = static_cast<int>(layer.passes.size());
    const auto add = [&](const Loop& loop) {
      Pass pass;
      pass.path = loop;
      pass.closed = true;
      pass.parent = parent;
      pass.component = component;
      layer.passes.push_back(std::move(pass));
    };
    add(ring.outer());
    for (const Loop& island : ring.islands()) add(island);
    add_rings(ring, outer, component, step, tol, layer);
  }
}

LayerPasses plan_rings(const Layer& layer, const Tolerances& tol) {
  if (!plan::closed_all_round(layer)) throw InputError("rings", "fills closed pockets alone");
  ClearingArea area = plan::clearing_area(layer, tol);  // passes along the walls, and what they leave
  LayerPasses result = std::move(area.walls);
  result.strategy = "rings";
  for (std::size_t i = 0; i < area.components.size(); ++i) {
    const auto& component = area.components[i];
    add_rings(component.legal, component.outer_wall, static_cast<int>(i), kStep * layer.tool_radius, tol,
              result);
  }
  return result;
}

}  // namespace

StrategyEntry entry() {
  StrategyEntry entry;
  entry.name = "rings";
  entry.description = "contours at half the radius, to the middle";
  entry.make = [](const StrategyRequest& request) {
    return plan::once_per_outline(
        [tol = request.plan.tol](const Layer& layer) { return plan_rings(layer, tol); });
  };
  entry.in_auto = AutoUse::kTried;
  return entry;
}

}  // namespace clearcut::test_support::rings
