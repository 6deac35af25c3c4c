#include "plan/cover/plan_cover.h"

#include <fmt/format.h>

#include "base/error.h"
#include "geometry/line_path.h"
#include "plan/common/clearing_area.h"
#include "plan/common/mend.h"

namespace clearcut::plan::cover {
namespace {

/// Room around an area, in radii, never left by a path of its cover.
constexpr double kRoomOfPath = 4;

/// Path through the points; for a single place one edge without length.
Path pass_through(const std::vector<Vec2>& points) {
  Path path = line_path(points);
  if (path.empty() && !points.empty()) path.push_back(Edge::line(points.front(), points.front()));
  return path;
}

void complete(Path& path, const LegalArea& legal, const ClearingComponent& component, double radius) {
  std::vector<Path> paths{path};
  const LegalArea inside(component.rest);
  MendJob job;
  job.radius = radius;
  job.residual = 0;
  job.matters = [&](Vec2 p) { return inside.contains(p); };
  job.legal = [&](Vec2 a, Vec2 b) { return legal.holds_line(a, b); };
  if (!mend(paths, job))
    throw InputError("cover", "found no path that clears the whole area; use another --strategy");
  path = std::move(paths.front());
}

}  // namespace

LayerPasses plan_cover(const Layer& layer, double corner_price, const CoverEffort& effort,
                       const Tolerances& tol) {
  ClearingArea area = clearing_area(layer, tol);
  LayerPasses result = std::move(area.walls);
  result.strategy = "cover";
  const double radius = layer.tool_radius;
  for (std::size_t i = 0; i < area.components.size(); ++i) {
    const ClearingComponent& component = area.components[i];
    if (component.rest.empty()) continue;
    const double squares = geometry::area(component.rest) / (4 * radius * radius);
    if (squares > kMostSquares)
      throw InputError(
          "cover", fmt::format("an area of {:.0f} square diameters is more than the {:.0f} that it searches; "
                               "use a wider cutter or another --strategy",
                               squares, kMostSquares));
    const LegalPaths legal({component.legal});
    CoverTask task;
    task.area = component.rest;
    task.radius = radius;
    task.corner_price = corner_price;
    if (!legal.area().surely_holds(box(component.rest).grown(kRoomOfPath * radius))) task.legal = &legal;
    const CoverResult found = shortest_cover(task, effort);
    if (found.points.empty())
      throw InputError("cover", "found no path that clears the whole area; use another --strategy");
    Pass pass;
    pass.path = pass_through(found.points);
    if (!found.proven) complete(pass.path, legal.area(), component, radius);
    pass.parent = component.outer_wall;
    pass.component = static_cast<int>(i);
    pass.start_priority = 2 * radius + layer.wall_stock;  // farther from walls than their passes
    result.passes.push_back(std::move(pass));
  }
  return result;
}

}  // namespace clearcut::plan::cover
