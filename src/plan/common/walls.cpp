#include "plan/common/walls.h"

#include "geometry/voronoi/clearance.h"
#include "plan/common/rings.h"

namespace clearcut::plan {
namespace {

void add_loops(const Region& region, LayerPasses& result) {
  const int component = static_cast<int>(result.legal.size());
  const auto add = [&](const Loop& loop) {
    Pass pass;
    pass.path = loop;
    pass.closed = true;
    pass.component = component;
    result.passes.push_back(std::move(pass));
  };
  add(region.outer());
  for (const Loop& island : region.islands()) add(island);
  result.legal.push_back(region);
}

}  // namespace

LayerPasses plan_walls(const Layer& layer, const Tolerances& tol) {
  LayerPasses result;
  result.z_top = layer.z_top;
  result.z = layer.z;
  result.target = layer.target;
  result.strategy = "walls";
  const double reach = layer.tool_radius + layer.wall_stock;
  for (const Region& region : layer.allowed) {
    const Clearance clearance(region, tol);
    for (const Region& inside : safe_inset(clearance, region, reach, tol)) add_loops(inside, result);
    for (const Path& line : clearance.fit_lines(reach, layer.reserve)) {
      result.fit_lines.push_back(line);
      Pass pass;
      pass.path = line;
      pass.closed = line.front().from == line.back().to && line.size() > 1;
      pass.component = static_cast<int>(result.legal.size());
      result.passes.push_back(std::move(pass));
    }
  }
  for (Pass& pass : result.passes) pass.offset = pass.start_priority = reach;
  return result;
}

}  // namespace clearcut::plan
