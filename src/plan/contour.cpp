// Source and symbols (CPO-kappa, CPO-rho):
//
//   paper   here                 unit   where
//   R       layer.tool_radius    mm
//   e       layer.wall_stock     mm     finishing allowance
//   H       step                 mm     R + e for the first contour, then 2 R kappa (CPO-kappa eq. 2)
//   kappa   kappa(), rho()              CPO-kappa eq. 6, CPO-rho eq. 8
//   A       see residual_paths   mm     the centre rule R < A < 2R holds for every maximum and ridge of the
//   clearance
//
// The contours come from one Voronoi diagram instead of edge by edge, so that vanishing edges (CPO-kappa alg.
// 2), splits and islands need no rule of their own. docs/contour.md tells the departures.
#include "plan/contour.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/error.h"
#include "geometry/boolean.h"
#include "plan/contour_residual.h"
#include "plan/contour_rings.h"

namespace clearcut {
namespace {

/// mm. By how much neighbouring rings overlap at the widest step: above the rounding of any program text.
constexpr double kOverlap = 0.006;
/// Steps smaller than this share of the radius are mistyped.
constexpr double kSmallestStep = 0.005;
/// 1 - cosine of the largest change of direction between lines that are drawn as one (0.001 degree).
constexpr double kCollinear = 1.5e-10;
/// mm. An edge of the target whose middle lies farther than this from every wall is open.
constexpr double kOpenDistance = 1e-3;

/// The published rule (CPO-rho eq. 8) has w = 1 mm, which makes no sense for cutters under 2 mm: w is at most
/// R / 2.
double rho_of(double alpha, double radius, double w) {
  return rho(alpha, radius, std::min(w, radius / 2));
}

double step_after(const Region& contour, const StepRule& rule, double radius) {
  switch (rule.kind) {
    case StepRule::Kind::kWidest:
      return 2 * radius - kOverlap;
    case StepRule::Kind::kKappa:
      return 2 * radius * kappa(smallest_angle(contour));
    case StepRule::Kind::kRho:
      return 2 * radius * rho_of(smallest_angle(contour), radius, rule.value);
    case StepRule::Kind::kSecondAngle:
      return 2 * radius * rho_of(second_smallest_angle(contour), radius, rule.value);
    case StepRule::Kind::kFraction:
      return 2 * radius * rule.value;
    case StepRule::Kind::kMm:
      break;
  }
  return std::min(rule.value, 2 * radius);
}

bool on_wall(Vec2 p, const Regions& allowed) {
  return std::any_of(allowed.begin(), allowed.end(),
                     [&](const Region& region) { return region.boundary_distance(p) <= kOpenDistance; });
}

bool has_wall(const Loop& loop, const Regions& allowed) {
  return std::any_of(loop.begin(), loop.end(), [&](const Edge& e) { return on_wall(e.at(0.5), allowed); });
}

bool has_open_side(const Loop& loop, const Regions& allowed) {
  return std::any_of(loop.begin(), loop.end(), [&](const Edge& e) { return !on_wall(e.at(0.5), allowed); });
}

/// How far beyond the target's open sides rings may use the air, mm (see docs/contour.md, "Open sides").
double reach_beyond(const Region& target, const Regions& allowed, double radius) {
  const auto islands_clear = [&](const Loop& island) {
    return std::all_of(island.begin(), island.end(), [&](const Edge& e) {
      return std::all_of(target.outer().begin(), target.outer().end(),
                         [&](const Edge& side) { return distance(e, side) > 3 * radius; });
    });
  };
  const bool face = !has_wall(target.outer(), allowed) &&
                    std::all_of(target.islands().begin(), target.islands().end(), islands_clear);
  if (!face) return 2 * radius;
  // The first ring runs inside the edge, just near enough to it to clear the sharpest corner.
  return radius - 0.98 * radius * std::sin(smallest_angle(target) / 2);
}

/// The target lies in `allowed`, so equal areas make them the same: a pocket closed all round.
bool closed_all_round(const Layer& layer) {
  const double whole = area(layer.allowed);
  return whole - area(layer.target) <= 1e-9 * whole;
}

/// Where rings are planned: `allowed`, less what lies far beyond the target's open sides.
Regions working_domain(const Layer& layer, const Tolerances& tol) {
  if (closed_all_round(layer)) return layer.allowed;
  Regions closed, open;
  double beyond = 0;
  for (const auto& target : layer.target) {
    const bool opens = has_open_side(target.outer(), layer.allowed) ||
                       std::any_of(target.islands().begin(), target.islands().end(),
                                   [&](const Loop& loop) { return has_open_side(loop, layer.allowed); });
    (opens ? open : closed).push_back(target);
    if (opens) beyond = std::max(beyond, reach_beyond(target, layer.allowed, layer.tool_radius));
  }
  if (!open.empty()) {
    const auto near = intersect(layer.allowed, dilate(open, beyond, tol), tol);
    closed.insert(closed.end(), near.begin(), near.end());
  }
  return closed;
}

/// Lines through the points, without those that lie on the way between their neighbours.
Path line_path(const std::vector<Vec2>& points, bool closed) {
  Path path;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i] == points[i - 1]) continue;
    const Edge edge = Edge::line(points[i - 1], points[i]);
    if (!path.empty() && dot(path.back().tangent_at(1), edge.tangent_at(0)) > 1 - kCollinear) {
      path.back().to = edge.to;
    } else {
      path.push_back(edge);
    }
  }
  if (closed && points.back() != points.front()) path.push_back(Edge::line(points.back(), points.front()));
  return path;
}

Nearest nearest_on(const Path& path, Vec2 p, std::size_t& edge) {
  Nearest best{{}, std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto candidate = nearest(path[i], p);
    if (candidate.distance < best.distance) {
      best = candidate;
      edge = i;
    }
  }
  return best;
}

/// Inserts a there-and-back way into a ring at the place nearest to where it begins.
void insert_ear(Path& ring, const std::vector<Vec2>& points) {
  std::size_t at = 0;
  const auto root = nearest_on(ring, points.front(), at);
  const Edge edge = ring[at];
  const double margin = 1e-4 / edge.length();
  std::vector<Vec2> way = points;
  Path pieces;
  if (root.t <= margin) {
    way.front() = edge.from;
  } else if (root.t >= 1 - margin) {
    way.front() = edge.to;
  } else {
    way.front() = root.point;
    pieces = {edge.part(0, root.t), edge.part(root.t, 1)};
  }
  way.back() = way.front();
  const Path ear = line_path(way, false);
  if (pieces.empty()) {
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(root.t > 0.5 ? at + 1 : at), ear.begin(),
                ear.end());
    return;
  }
  pieces.insert(pieces.begin() + 1, ear.begin(), ear.end());
  ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(at), pieces.begin(), pieces.end());
}

/// Turns the ring trees of one layer into passes.
class PassBuilder {
 public:
  PassBuilder(const Layer& layer, const ContourOptions& options) : layer_(layer), options_(options) {}

  void add_region(const Region& domain, const Tolerances& tol) {
    const Clearance clearance(domain, tol);
    const double first = layer_.tool_radius + layer_.wall_stock;
    const auto step = [&](const Region& contour) {
      return std::max(step_after(contour, options_.step, layer_.tool_radius),
                      kSmallestStep * layer_.tool_radius);
    };
    const auto nodes = ring_tree(clearance, domain, first, step, tol);
    add_rings(nodes);
    if (options_.residuals == ResidualRule::kOurs) add_residuals(nodes);
    for (const auto& line : clearance.fit_lines(first)) add_fit_line(line, first);
  }

  std::vector<Pass> take_passes() { return std::move(passes_); }

 private:
  void add_rings(const std::vector<RingNode>& nodes) {
    rings_of_.assign(nodes.size(), {});
    component_of_.assign(nodes.size(), 0);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const int parent = nodes[i].parent;
      component_of_[i] = parent < 0 ? components_++ : component_of_[static_cast<std::size_t>(parent)];
      add_ring(i, nodes[i].contour.outer(), nodes[i]);
      for (const auto& island : nodes[i].contour.islands()) add_ring(i, island, nodes[i]);
    }
  }

  void add_ring(std::size_t node, const Loop& loop, const RingNode& ring) {
    Pass pass;
    pass.path = loop;
    pass.closed = true;
    pass.parent =
        ring.parent < 0 ? -1 : nearest_ring(static_cast<std::size_t>(ring.parent), loop.front().from);
    pass.component = component_of_[node];
    pass.offset = ring.level;
    pass.reversible = false;
    rings_of_[node].push_back(passes_.size());
    passes_.push_back(std::move(pass));
  }

  int nearest_ring(std::size_t node, Vec2 p) const {
    std::size_t best = rings_of_[node].front(), edge = 0;
    if (rings_of_[node].size() == 1) return static_cast<int>(best);
    double best_distance = std::numeric_limits<double>::infinity();
    for (const std::size_t ring : rings_of_[node]) {
      const double d = nearest_on(passes_[ring].path, p, edge).distance;
      if (d < best_distance) {
        best_distance = d;
        best = ring;
      }
    }
    return static_cast<int>(best);
  }

  void add_residuals(const std::vector<RingNode>& nodes) {
    // At the widest step the rings overlap by kOverlap, shared by both sides.
    const bool widest = options_.step.kind == StepRule::Kind::kWidest;
    const double radius = layer_.tool_radius - (widest ? kOverlap / 2 : 0.0);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (const auto& residual : residual_paths(nodes[i], radius)) {
        if (residual.rooted) {
          insert_ear(passes_[ring_at_root(nodes[i], residual.points.front())].path, residual.points);
        } else {
          add_ridge(i, residual);
        }
      }
    }
  }

  std::size_t ring_at_root(const RingNode& node, Vec2 root) const {
    std::size_t best = 0, edge = 0;
    double best_distance = std::numeric_limits<double>::infinity();
    for (const int child : node.children) {
      for (const std::size_t ring : rings_of_[static_cast<std::size_t>(child)]) {
        const double d = nearest_on(passes_[ring].path, root, edge).distance;
        if (d < best_distance) {
          best_distance = d;
          best = ring;
        }
      }
    }
    return best;
  }

  void add_ridge(std::size_t node, const ResidualPath& residual) {
    Pass pass;
    pass.parent = nearest_ring(node, residual.points.front());
    pass.closed = residual.closed;
    pass.path = line_path(residual.points, residual.closed);
    if (pass.path.empty()) {
      // All can be cleared from one point: reached on the way from the ring around it.
      std::size_t edge = 0;
      const auto foot =
          nearest_on(passes_[static_cast<std::size_t>(pass.parent)].path, residual.points[0], edge);
      pass.path = {Edge::line(residual.points[0], foot.point)};
    }
    pass.component = component_of_[node];
    pass.offset = passes_[static_cast<std::size_t>(pass.parent)].offset;
    passes_.push_back(std::move(pass));
  }

  void add_fit_line(const Path& line, double offset) {
    Pass pass;
    pass.path = line;
    pass.closed = line.size() > 1 && line.front().from == line.back().to;
    pass.component = components_++;
    pass.offset = offset;
    passes_.push_back(std::move(pass));
  }

  const Layer& layer_;
  const ContourOptions& options_;
  std::vector<Pass> passes_;
  std::vector<std::vector<std::size_t>> rings_of_;  ///< per node: indices of passes, outer first
  std::vector<int> component_of_;
  int components_ = 0;
};

Regions legal_centers(const Layer& layer, const Tolerances& tol) {
  Regions legal;
  for (const auto& region : layer.allowed) {
    const auto inside = safe_inset(Clearance(region, tol), region, layer.tool_radius + layer.wall_stock, tol);
    legal.insert(legal.end(), inside.begin(), inside.end());
  }
  return legal;
}

}  // namespace

LayerPasses plan_contour(const Layer& layer, const ContourOptions& options, const Tolerances& tol) {
  CLEARCUT_ASSERT(layer.tool_radius > 0);
  LayerPasses result;
  result.z_top = layer.z_top;
  result.z = layer.z;
  result.target = layer.target;
  result.strategy = "contour";
  result.legal = legal_centers(layer, tol);
  PassBuilder builder(layer, options);
  for (const auto& domain : working_domain(layer, tol)) builder.add_region(domain, tol);
  result.passes = builder.take_passes();
  for (const auto& pass : result.passes) {
    if (!pass.closed && pass.parent < 0) result.fit_lines.push_back(pass.path);
  }
  return result;
}

}  // namespace clearcut
