#include "plan/common/clearing_area.h"

#include <algorithm>
#include <cmath>

#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"
#include "plan/common/pass_parts.h"
#include "plan/common/rings.h"

namespace clearcut::plan {
namespace {

/// mm. Residual permitted between two walls two diameters apart: offsets are exact to this.
constexpr double kResidual = 0.001;
/// mm. On layers without any permitted residual, the rest is wider by this, so that it overlaps with the area cleared
/// by the wall passes.
constexpr double kBareMargin = 0.002;
/// mm. Stretches of walls extend by this beyond the places from which the target can be reached.
constexpr double kWallMargin = 0.01;

class AreaBuilder {
 public:
  AreaBuilder(const Layer& layer, const Tolerances& tol)
      : layer_(layer), tol_(tol), closed_(closed_all_round(layer)) {
    area_.walls.z_top = layer.z_top;
    area_.walls.z = layer.z;
    area_.walls.target = layer.target;
    bare_ = layer.bare || !closed_;
    area_.walls.residual = bare_ ? 0 : kResidual;
    if (!closed_) near_ = dilate(layer.target, layer.tool_radius + layer.rounded + kWallMargin, tol);
  }

  ClearingArea build() {
    const double first = layer_.tool_radius + layer_.wall_stock;
    std::vector<Path> lines;
    for (const auto& allowed : layer_.allowed) {
      const Clearance clearance(allowed, tol_);
      const auto legal = safe_inset(clearance, allowed, first, tol_);
      // Rounding in the program's digits may move the wall pass and the pass beside it: the rest is wider by
      // both.
      const double coarse = layer_.reserve > 0 ? 2 * layer_.reserve + tol_.gouge : 0;
      const auto deep =
          clearance.inset(first + layer_.tool_radius - std::max(bare_ ? kBareMargin : 0, coarse));
      const auto begin = area_.components.size();
      for (const auto& region : legal) area_.components.push_back({region, {}, -1});
      share_out(closed_ ? deep : target_within(deep), begin);
      for (auto& line : clearance.fit_lines(first, layer_.reserve)) lines.push_back(std::move(line));
    }
    for (std::size_t i = 0; i < area_.components.size(); ++i) add_walls(static_cast<int>(i));
    for (const auto& line : lines) add_fit_line(line);
    for (const auto& component : area_.components) area_.walls.legal.push_back(component.legal);
    return std::move(area_);
  }

 private:
  /// The target inside `deep`. Slivers dropped as empty by boolean operations are kept.
  Regions target_within(const Regions& deep) const {
    Regions found;
    for (const auto& region : layer_.target) {
      auto pieces = intersect({region}, deep, tol_);
      if (pieces.empty() && contains(deep, region.outer().front().from)) pieces.push_back(region);
      found.insert(found.end(), pieces.begin(), pieces.end());
    }
    return found;
  }

  /// Assigns each region of the rest to the component around it, among the components from `begin` on.
  void share_out(const Regions& rest, std::size_t begin) {
    for (const auto& region : rest) {
      for (std::size_t i = begin; i < area_.components.size(); ++i) {
        auto& component = area_.components[i];
        const bool only = begin + 1 == area_.components.size();
        if (!only && !component.legal.contains(region.outer().front().from)) continue;
        component.rest.push_back(region);
        break;
      }
    }
  }

  void add_walls(int component) {
    auto& own = area_.components[static_cast<std::size_t>(component)];
    const auto first = area_.walls.passes.size();
    add_loop(own.legal.outer(), component);
    for (const auto& island : own.legal.islands()) add_loop(island, component);
    if (area_.walls.passes.size() > first) own.outer_wall = static_cast<int>(first);
  }

  void add_loop(const Loop& loop, int component) {
    if (closed_) return add_wall(loop, true, component);
    for (const auto& stretch : stretches_inside(loop, true, near_)) {
      add_wall(stretch, stretch.front().from == stretch.back().to, component);
    }
  }

  void add_wall(const Path& path, bool closed, int component) {
    Pass pass;
    pass.path = path;
    pass.closed = closed;
    pass.component = component;
    pass.offset = pass.start_priority = layer_.tool_radius + layer_.wall_stock;
    pass.reversible = !closed;
    area_.walls.passes.push_back(std::move(pass));
  }

  void add_fit_line(const Path& line) {
    const bool reaches = closed_ || std::any_of(line.begin(), line.end(), [&](const Edge& edge) {
                           return contains(near_, edge.at(0.5));
                         });
    if (!reaches) return;
    add_wall(line, line.size() > 1 && line.front().from == line.back().to,
             static_cast<int>(area_.components.size() + area_.walls.fit_lines.size()));
    area_.walls.passes.back().reversible = true;
    area_.walls.fit_lines.push_back(line);
  }

  const Layer& layer_;
  const Tolerances& tol_;
  bool closed_;
  bool bare_ = false;  ///< not even a thin residual may stay
  /// Positions of the cutter's centre that reach the target; on layers with open sides only.
  Regions near_;
  ClearingArea area_;
};

}  // namespace

bool closed_all_round(const Layer& layer) {
  const double whole = area(layer.allowed);
  return whole - area(layer.target) <= 1e-9 * whole;
}

ClearingArea clearing_area(const Layer& layer, const Tolerances& tol) {
  return AreaBuilder(layer, tol).build();
}

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

double engagement_along_wall(double radius, double stock) {
  return base::acos(std::max(-1.0, 1 - stock / radius));
}

namespace {

/// Radians; the engagement inside a wall round an arc; at the most what its turn adds to the straight wall.
double engagement_inside(const Edge& arc, double radius, double stock) {
  const double wall = arc.radius(), away = wall - radius;
  const double most = std::min(kPi, engagement_along_wall(radius, stock) + arc.sweep());
  if (away <= 0) return most;
  const double inside = wall - stock;
  const double cosine = (inside * inside - away * away - radius * radius) / (2 * away * radius);
  return std::min(most, base::acos(std::clamp(cosine, -1.0, 1.0)));
}

double engagement_along(const Loop& loop, double radius, double stock) {
  double most = engagement_along_wall(radius, stock);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Edge& edge = loop[i];
    const Vec2 in = edge.tangent_at(1), out = loop[(i + 1) % loop.size()].tangent_at(0);
    const double turn = base::atan2(cross(in, out), dot(in, out));
    most = std::max(most, engagement_along_wall(radius, stock) + turn);
    if (edge.turn == Turn::kCounterClockwise) most = std::max(most, engagement_inside(edge, radius, stock));
  }
  return most;
}

}  // namespace

double engagement_along_walls(const Regions& area, double radius, double stock) {
  double most = 0;
  for (const Region& region : area) {
    most = std::max(most, engagement_along(region.outer(), radius, stock));
    for (const Loop& island : region.islands())
      most = std::max(most, engagement_along(island, radius, stock));
  }
  return most;
}

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
