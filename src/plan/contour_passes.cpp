#include "plan/contour_passes.h"

#include <limits>

#include "plan/contour_residual.h"

namespace clearcut {
namespace {

/// 1 - cosine of the largest change of direction between lines that are drawn as one (0.001 degree).
constexpr double kCollinear = 1.5e-10;

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
  PassBuilder(const RingJob& job, const Tolerances& tol) : job_(job), tol_(tol) {}

  void add_domain(const Domain& domain) {
    const auto nodes = ring_tree(domain.clearance, domain.region, job_.first_level, job_.step, tol_);
    add_rings(nodes);
    if (job_.clear_residuals) add_residuals(nodes);
  }

  void add_fit_lines(const Domain& domain) {
    for (const auto& line : domain.clearance.fit_lines(job_.first_level)) add_fit_line(line);
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
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (const auto& residual : residual_paths(nodes[i], job_.radius)) {
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

  void add_fit_line(const Path& line) {
    Pass pass;
    pass.path = line;
    pass.closed = line.size() > 1 && line.front().from == line.back().to;
    pass.component = components_++;
    pass.offset = job_.first_level;
    passes_.push_back(std::move(pass));
  }

  const RingJob& job_;
  const Tolerances& tol_;
  std::vector<Pass> passes_;
  std::vector<std::vector<std::size_t>> rings_of_;  ///< per node: indices of passes, outer first
  std::vector<int> component_of_;
  int components_ = 0;
};

}  // namespace

std::vector<Pass> ring_passes(const std::vector<Domain>& domains, const RingJob& job, const Tolerances& tol) {
  PassBuilder builder(job, tol);
  for (const auto& domain : domains) builder.add_domain(domain);
  for (const auto& domain : domains) builder.add_fit_lines(domain);
  return builder.take_passes();
}

}  // namespace clearcut
