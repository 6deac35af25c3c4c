// Source [elber2005], with these symbols:
//
//   paper        here                       unit
//   MA           axis of the clearance
//   r(t)         Disc::radius               mm   clearance less the stock to leave on walls
//   step         solved by farthest()       mm   the widest whose contact stays below the limit
//
// The paper chooses the step by a bound; here the contact between two discs is known in closed form, so the
// step is the widest that keeps the limit.
#include "plan/adaptive.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/clearance.h"
#include "plan/clearing_path.h"

namespace clearcut {
namespace {

/// mm. Places that stand out of what is cleared by less are left to the wall pass.
constexpr double kProtrusion = 0.02;
/// Steps are at least this share of the radius: where even that exceeds the limit, the channel is a slot.
constexpr double kLeastStep = 0.04;
/// Radians. What rounding in the program and the sampling of the contact may add; kept off the limit.
constexpr double kContactMargin = 0.01;
/// Radius of the entry circle as a share of the cutter's: below 1 no post is left in its middle.
constexpr double kEntryCircle = 0.8;

/// A way along the axis still to be walked: over `edge` away from `node`, where `disc` is cleared.
struct Branch {
  int node = 0;
  int edge = 0;
  int disc = 0;
};

class AdaptivePlanner {
 public:
  AdaptivePlanner(const Region& region, const Layer& layer, const AdaptiveOptions& options,
                  const Tolerances& tol)
      : region_(region),
        clearance_(region, tol),
        radius_(layer.tool_radius),
        stock_(layer.wall_stock),
        limit_(options.engagement.radians() - kContactMargin),
        path_(layer.tool_radius) {
    const auto& axis = clearance_.axis();
    edges_at_.resize(axis.points.size());
    for (std::size_t e = 0; e < axis.edges.size(); ++e) {
      edges_at_[static_cast<std::size_t>(axis.edges[e].a)].push_back(static_cast<int>(e));
      edges_at_[static_cast<std::size_t>(axis.edges[e].b)].push_back(static_cast<int>(e));
    }
    walked_.assign(axis.edges.size(), false);
    cleared_at_.assign(axis.points.size(), -1);
  }

  /// One pass for every connected part of the legal area.
  std::vector<Pass> plan() {
    std::vector<Pass> passes;
    for (int start = widest_left(); start >= 0; start = widest_left()) {
      path_ = ClearingPath(radius_);
      const int first = path_.open(disc_at(start), kEntryCircle * radius_, limit_);
      cleared_at_[static_cast<std::size_t>(start)] = first;
      push_branches(start, first);
      while (!branches_.empty()) {
        const Branch branch = branches_.back();
        branches_.pop_back();
        if (!walked_[static_cast<std::size_t>(branch.edge)]) walk(branch);
      }
      Pass pass = path_.finish(static_cast<int>(passes.size()));
      if (pass.path.empty()) continue;  // no room but for a plunge: see Clearance::fit_lines
      pass.offset = point(start).clearance;
      passes.push_back(std::move(pass));
    }
    return passes;
  }

  const Clearance& clearance() const { return clearance_; }

 private:
  const AxisPoint& point(int node) const { return clearance_.axis().points[static_cast<std::size_t>(node)]; }
  Disc disc_at(int node) const { return {point(node).point, point(node).clearance - stock_}; }
  Disc disc_at(Vec2 p) const { return {p, region_.boundary_distance(p) - stock_}; }
  bool has_room(const Disc& disc) const { return disc.radius >= radius_; }
  static double protrusion(const Disc& cleared, const Disc& disc) {
    return distance(cleared.center, disc.center) + disc.radius - cleared.radius;
  }

  int other_end(int edge, int node) const {
    const auto& e = clearance_.axis().edges[static_cast<std::size_t>(edge)];
    return e.a == node ? e.b : e.a;
  }

  /// The widest place that nothing has reached yet; -1 when there is none with room.
  int widest_left() const {
    int best = -1;
    for (int i = 0; i < static_cast<int>(edges_at_.size()); ++i) {
      const auto& edges = edges_at_[static_cast<std::size_t>(i)];
      const bool reached = cleared_at_[static_cast<std::size_t>(i)] >= 0 ||
                           std::any_of(edges.begin(), edges.end(),
                                       [&](int e) { return walked_[static_cast<std::size_t>(e)]; });
      if (reached || !has_room(disc_at(i))) continue;
      if (best < 0 || point(i).clearance > point(best).clearance) best = i;
    }
    return best;
  }

  /// Pushes the ways on from a node, the longest first, so that it is walked last and needs no way back.
  void push_branches(int node, int disc) {
    std::vector<std::pair<double, int>> ways;
    for (const int edge : edges_at_[static_cast<std::size_t>(node)]) {
      if (walked_[static_cast<std::size_t>(edge)]) continue;
      const double extent = extent_beyond(node, edge, path_.disc(disc));
      if (extent > 0) {
        ways.push_back({extent, edge});
      } else {
        prune(node, edge);
      }
    }
    std::stable_sort(ways.begin(), ways.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    for (const auto& [extent, edge] : ways) branches_.push_back({node, edge, disc});
  }

  /// How much axis lies beyond `edge`, up to a bound; 0 when all its discs are as good as cleared.
  double extent_beyond(int node, int edge, const Disc& cleared) {
    double extent = 0;
    bool stands_out = false;
    std::vector<Branch> todo{{node, edge, 0}};
    std::vector<int> seen;
    while (!todo.empty() && static_cast<int>(seen.size()) < kLookAhead) {
      const Branch way = todo.back();
      todo.pop_back();
      if (std::find(seen.begin(), seen.end(), way.edge) != seen.end()) continue;
      seen.push_back(way.edge);
      const int end = other_end(way.edge, way.node);
      extent += distance(point(way.node).point, point(end).point);
      const Disc disc = disc_at(end);
      stands_out = stands_out || (has_room(disc) ? protrusion(cleared, disc) > kProtrusion
                                                 : has_room_beyond(way.node, end, cleared));
      if (!has_room(disc)) continue;
      for (const int next : edges_at_[static_cast<std::size_t>(end)]) {
        if (!walked_[static_cast<std::size_t>(next)]) todo.push_back({end, next, 0});
      }
    }
    return stands_out ? extent : 0;
  }

  /// Whether the last place with room on the way from `node` to `end` stands out of what is cleared.
  bool has_room_beyond(int node, int end, const Disc& cleared) const {
    const Disc last = disc_at(lerp(point(node).point, point(end).point, last_room(node, end)));
    return has_room(last) && protrusion(cleared, last) > kProtrusion;
  }

  /// Marks everything beyond an edge that adds nothing as done.
  void prune(int node, int edge) {
    std::vector<Branch> todo{{node, edge, 0}};
    while (!todo.empty()) {
      const Branch way = todo.back();
      todo.pop_back();
      if (walked_[static_cast<std::size_t>(way.edge)]) continue;
      walked_[static_cast<std::size_t>(way.edge)] = true;
      const int end = other_end(way.edge, way.node);
      if (!has_room(disc_at(end))) continue;
      for (const int next : edges_at_[static_cast<std::size_t>(end)]) todo.push_back({end, next, 0});
    }
  }

  /// The greatest parameter between two nodes with room; the first has it.
  double last_room(int node, int end) const {
    if (has_room(disc_at(end))) return 1;
    double low = 0, high = 1;
    for (int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2;
      (has_room(disc_at(lerp(point(node).point, point(end).point, middle))) ? low : high) = middle;
    }
    return low;
  }

  /// Walks from node to node, cutting a disc wherever the contact from the last one would exceed the limit.
  void walk(Branch way) {
    for (;;) {
      walked_[static_cast<std::size_t>(way.edge)] = true;
      const int end = other_end(way.edge, way.node);
      const double last = last_room(way.node, end);
      way.disc = cut_along(way, end, last);
      if (last < 1)
        return cut_if_standing(way.disc, disc_at(lerp(point(way.node).point, point(end).point, last)));
      auto& cleared_here = cleared_at_[static_cast<std::size_t>(end)];
      if (cleared_here >= 0) return;
      std::vector<int> on;
      for (const int edge : edges_at_[static_cast<std::size_t>(end)]) {
        if (!walked_[static_cast<std::size_t>(edge)]) on.push_back(edge);
      }
      if (on.size() == 1) {
        way = {end, on.front(), way.disc};
        continue;
      }
      if (protrusion(path_.disc(way.disc), disc_at(end)) > kProtrusion)
        way.disc = path_.widen(way.disc, disc_at(end));
      cleared_here = way.disc;
      return push_branches(end, way.disc);
    }
  }

  void cut_if_standing(int from, const Disc& disc) {
    if (has_room(disc) && protrusion(path_.disc(from), disc) > kProtrusion) path_.widen(from, disc);
  }

  /// Cuts the discs needed between way.node and the parameter `last` towards `end`; returns the last disc
  /// cut.
  int cut_along(const Branch& way, int end, double last) {
    const Vec2 a = point(way.node).point, b = point(end).point;
    const double least = kLeastStep * radius_ / std::max(distance(a, b), 1e-9);
    int disc = way.disc;
    for (double t = 0; t < last;) {
      if (contact(disc, disc_at(lerp(a, b, last))) <= limit_) return disc;
      const double next = std::min(last, std::max(farthest(disc, a, b, t, last), t + least));
      const Disc wanted = disc_at(lerp(a, b, next));
      if (!has_room(wanted)) return disc;
      if (protrusion(path_.disc(disc), wanted) > kProtrusion) disc = path_.widen(disc, wanted);
      t = next;
    }
    return disc;
  }

  double contact(int disc, const Disc& next) const {
    return crescent_engagement(path_.disc(disc), next, radius_);
  }

  /// The greatest parameter in [from, last] where the contact keeps the limit.
  double farthest(int disc, Vec2 a, Vec2 b, double from, double last) const {
    double low = from, high = last;
    for (int i = 0; i < 24; ++i) {
      const double middle = (low + high) / 2;
      (contact(disc, disc_at(lerp(a, b, middle))) <= limit_ ? low : high) = middle;
    }
    return low;
  }

  static constexpr int kLookAhead = 400;

  const Region& region_;
  Clearance clearance_;
  double radius_;
  double stock_;
  double limit_;
  ClearingPath path_;
  std::vector<std::vector<int>> edges_at_;
  std::vector<bool> walked_;
  std::vector<int> cleared_at_;  ///< disc that clears a node, -1 none
  std::vector<Branch> branches_;
};

void add_wall_passes(LayerPasses& result, const Regions& legal, int first_component) {
  for (const auto& region : legal) {
    const auto add = [&](const Loop& loop) {
      Pass pass;
      pass.path = loop;
      pass.closed = true;
      pass.component = first_component;
      result.passes.push_back(std::move(pass));
    };
    add(region.outer());
    for (const auto& island : region.islands()) add(island);
  }
}

void add_fit_lines(LayerPasses& result, const std::vector<Path>& lines) {
  for (const auto& line : lines) {
    Pass pass;
    pass.path = line;
    pass.closed = line.size() > 1 && line.front().from == line.back().to;
    pass.component = static_cast<int>(result.passes.size());
    result.passes.push_back(std::move(pass));
    result.fit_lines.push_back(line);
  }
}

}  // namespace

LayerPasses plan_adaptive(const Layer& layer, const AdaptiveOptions& options, const Tolerances& tol) {
  LayerPasses result;
  result.z_top = layer.z_top;
  result.z = layer.z;
  result.target = layer.target;
  result.strategy = "adaptive";
  const double first = layer.tool_radius + layer.wall_stock;
  for (const auto& region : layer.allowed) {
    AdaptivePlanner planner(region, layer, options, tol);
    auto passes = planner.plan();
    auto legal = planner.clearance().inset(first);
    const auto wall = static_cast<int>(result.passes.size());
    add_wall_passes(result, legal, wall);
    for (auto& pass : passes) {
      pass.parent = static_cast<int>(result.passes.size()) > wall ? wall : -1;
      pass.component = wall;
      result.passes.push_back(std::move(pass));
    }
    add_fit_lines(result, planner.clearance().fit_lines(first, layer.reserve));
    result.legal.insert(result.legal.end(), std::make_move_iterator(legal.begin()),
                        std::make_move_iterator(legal.end()));
  }
  return result;
}

}  // namespace clearcut
