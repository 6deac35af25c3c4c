#include "plan/contour/skeleton/skeleton.h"

#include <algorithm>
#include <limits>

namespace clearcut::plan::contour {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A place on a closed path.
struct RingPlace {
  std::size_t edge = 0;
  double t = 0;
  Vec2 point;
  double distance = kInfinity;
  double order() const { return static_cast<double>(edge) + t; }
};

RingPlace place_on(const Path& ring, Vec2 p) {
  RingPlace best;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto on = nearest(ring[i], p);
    if (on.distance < best.distance) best = {i, on.t, on.point, on.distance};
  }
  return best;
}

/// The part of a ring from one place to another in its direction; the whole ring if they are the same.
Path ring_part(const Path& ring, const RingPlace& from, const RingPlace& to) {
  Path part;
  const auto add = [&](const Edge& e, double t0, double t1) {
    if ((t1 - t0) * e.length() > 1e-7) part.push_back(t0 == 0 && t1 == 1 ? e : e.part(t0, t1));
  };
  if (from.edge == to.edge && from.t < to.t) {
    add(ring[from.edge], from.t, to.t);
    return part;
  }
  add(ring[from.edge], from.t, 1);
  for (std::size_t i = (from.edge + 1) % ring.size(); i != to.edge; i = (i + 1) % ring.size())
    part.push_back(ring[i]);
  add(ring[to.edge], 0, to.t);
  return part;
}

std::vector<Vec2> polygon_of(const Path& path, double chord) {
  std::vector<Vec2> points{path.front().from};
  for (const auto& edge : path) append_flattened(edge, chord, points);
  return points;
}

class SkeletonBuilder {
 public:
  SkeletonBuilder(const std::vector<Pass>& passes, const SkeletonOptions& options)
      : passes_(passes), options_(options), children_(passes.size()), weight_(passes.size(), 0) {
    for (std::size_t i = 0; i < passes.size(); ++i) {
      if (passes[i].parent >= 0) children_[static_cast<std::size_t>(passes[i].parent)].push_back(i);
    }
    // Parents come before their children.
    for (std::size_t i = passes.size(); i-- > 0;) {
      weight_[i] += length(passes[i].path);
      if (passes[i].parent >= 0) weight_[static_cast<std::size_t>(passes[i].parent)] += weight_[i];
      std::sort(children_[i].begin(), children_[i].end(),
                [&](std::size_t a, std::size_t b) { return weight_[a] > weight_[b]; });
    }
    flexible_ = children_;
    for (auto& children : flexible_) std::erase_if(children, [&](std::size_t child) { return stays(child); });
  }

  Skeleton build() {
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < passes_.size(); ++i) {
      if (passes_[i].parent < 0 && passes_[i].closed) roots.push_back(i);
    }
    std::sort(roots.begin(), roots.end(),
              [&](std::size_t a, std::size_t b) { return weight_[a] > weight_[b]; });
    while (!roots.empty()) {
      const std::size_t next = nearest_root(roots);
      add_tree(roots[next]);
      roots.erase(roots.begin() + static_cast<std::ptrdiff_t>(next));
    }
    return std::move(skeleton_);
  }

 private:
  Vec2 at(int point) const { return skeleton_.points[static_cast<std::size_t>(point)].at; }

  int add_point(Vec2 p, int ring = -1) {
    skeleton_.points.push_back({p, ring});
    return static_cast<int>(skeleton_.points.size()) - 1;
  }

  bool stays(std::size_t i) const {
    return passes_[i].closed &&
           (passes_[i].parent < 0 || weight_[i] - length(passes_[i].path) > options_.flexible);
  }

  /// The point at which the paths inside pass i would be entered from p.
  Vec2 entry_of(std::size_t i, Vec2 p) const {
    while (!flexible_[i].empty()) i = flexible_[i].front();
    if (passes_[i].closed) return place_on(passes_[i].path, p).point;
    const Vec2 a = passes_[i].path.front().from, b = passes_[i].path.back().to;
    return distance(a, p) <= distance(b, p) ? a : b;
  }

  std::size_t nearest_root(const std::vector<std::size_t>& roots) const {
    if (skeleton_.legs.empty()) return 0;
    std::size_t best = 0;
    double best_distance = kInfinity;
    for (std::size_t k = 0; k < roots.size(); ++k) {
      const double d = distance(entry_of(roots[k], at(last_)), at(last_));
      if (d < best_distance) {
        best_distance = d;
        best = k;
      }
    }
    return best;
  }

  /// Adds the unchanged rings, from the inside out, each with a Leg leading to it.
  void add_tree(std::size_t root) {
    std::vector<std::size_t> outside_in, open{root};
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      outside_in.push_back(i);
      for (const std::size_t child : children_[i]) {
        if (stays(child)) open.push_back(child);
      }
    }
    for (auto i = outside_in.rbegin(); i != outside_in.rend(); ++i) add_leg(*i);
  }

  void add_leg(std::size_t root) {
    Leg leg;
    std::vector<int> vertices;
    leg.retracted = skeleton_.legs.empty() || !may_stay_down(root);
    if (!leg.retracted) vertices.push_back(last_);
    leg.ring = static_cast<int>(skeleton_.rings.size());
    skeleton_.rings.push_back(passes_[root].path);
    if (!flexible_[root].empty()) spiral_out(flexible_[root].front(), vertices);
    const Vec2 from = vertices.empty() ? passes_[root].path.front().from : at(vertices.back());
    vertices.push_back(add_point(place_on(passes_[root].path, from).point, leg.ring));
    for (std::size_t k = 1; k < flexible_[root].size(); ++k)
      leg.detours.push_back(ring_detour(root, k, leg.ring));
    last_ = vertices.back();
    leg.path_in = std::move(vertices);
    skeleton_.legs.push_back(std::move(leg));
  }

  bool may_stay_down(std::size_t root) const {
    const Vec2 entry = entry_of(root, at(last_));
    return distance(entry, at(last_)) <= options_.retract_cost && options_.legal(at(last_), entry);
  }

  std::vector<int> ring_detour(std::size_t root, std::size_t k, int ring) {
    const std::size_t child = flexible_[root][k];
    const auto entrance = place_on(passes_[root].path, nearest_to_ring(child, passes_[root].path));
    std::vector<int> vertices{add_point(entrance.point, ring)};
    detour(child, vertices);
    vertices.push_back(vertices.front());
    return vertices;
  }

  /// The vertex of the pass nearest to the ring.
  Vec2 nearest_to_ring(std::size_t pass, const Path& ring) const {
    Vec2 best;
    double best_distance = kInfinity;
    for (const auto& edge : passes_[pass].path) {
      const auto on = place_on(ring, edge.from);
      if (on.distance < best_distance) {
        best_distance = on.distance;
        best = edge.from;
      }
    }
    return best;
  }

  void walk_open(std::size_t i, std::vector<int>& vertices) {
    auto points = polygon_of(passes_[i].path, options_.chord);
    const Vec2 toward = vertices.empty() ? Vec2{} : at(vertices.back());
    const bool turn = vertices.empty() ? passes_[i].parent >= 0 && ends_away_from_parent(i)
                                       : distance(points.back(), toward) < distance(points.front(), toward);
    if (turn) std::reverse(points.begin(), points.end());
    for (const Vec2 p : points) vertices.push_back(add_point(p));
  }

  bool ends_away_from_parent(std::size_t i) const {
    const auto& ring = passes_[static_cast<std::size_t>(passes_[i].parent)].path;
    return place_on(ring, passes_[i].path.front().from).distance <
           place_on(ring, passes_[i].path.back().to).distance;
  }

  /// Adds everything inside pass i, then pass i itself.
  void spiral_out(std::size_t i, std::vector<int>& vertices) {
    if (!children_[i].empty()) spiral_out(children_[i].front(), vertices);
    if (!passes_[i].closed) return walk_open(i, vertices);
    const auto& ring = passes_[i].path;
    go_round(i, place_on(ring, vertices.empty() ? beginning_of(ring) : at(vertices.back())), vertices);
  }

  /// The start of the innermost ring.
  Vec2 beginning_of(const Path& ring) const {
    return options_.begin ? place_on(ring, *options_.begin).point : ring.front().from;
  }

  /// Adds a path into pass i and all passes inside it, innermost first, and back to its entry point.
  void detour(std::size_t i, std::vector<int>& vertices) {
    if (!passes_[i].closed) return walk_open(i, vertices);
    const auto entrance = place_on(passes_[i].path, at(vertices.back()));
    if (!children_[i].empty()) {
      vertices.push_back(add_point(entrance.point));
      detour(children_[i].front(), vertices);
    }
    go_round(i, entrance, vertices);
  }

  /// Adds ring i once round from `start`, with detours to all its children but the first.
  void go_round(std::size_t i, const RingPlace& start, std::vector<int>& vertices) {
    const auto& ring = passes_[i].path;
    std::vector<std::pair<RingPlace, std::size_t>> stops;
    for (std::size_t k = 1; k < children_[i].size(); ++k) {
      stops.emplace_back(place_on(ring, nearest_to_ring(children_[i][k], ring)), children_[i][k]);
    }
    const auto ahead = [&](const RingPlace& p) {
      const double d = p.order() - start.order();
      return d < 0 ? d + static_cast<double>(ring.size()) : d;
    };
    std::sort(stops.begin(), stops.end(),
              [&](const auto& a, const auto& b) { return ahead(a.first) < ahead(b.first); });
    vertices.push_back(add_point(start.point));
    RingPlace from = start;
    for (const auto& [stop, child] : stops) {
      if (ahead(stop) > ahead(from)) follow(ring_part(ring, from, stop), vertices);
      detour(child, vertices);
      vertices.push_back(add_point(stop.point));
      from = stop;
    }
    follow(ring_part(ring, from, start), vertices);
  }

  void follow(const Path& path, std::vector<int>& vertices) {
    std::vector<Vec2> points;
    for (const auto& edge : path) append_flattened(edge, options_.chord, points);
    for (const Vec2 p : points) vertices.push_back(add_point(p));
  }

  const std::vector<Pass>& passes_;
  const SkeletonOptions& options_;
  /// The child with the greatest length of path inside it first.
  std::vector<std::vector<std::size_t>> children_;
  std::vector<std::vector<std::size_t>> flexible_;  ///< changeable ones among them
  std::vector<double> weight_;                      ///< mm; length of the pass and of all passes inside it
  Skeleton skeleton_;
  int last_ = -1;
};

void append_lines(const Skeleton& skeleton, const std::vector<int>& vertices, Path& path) {
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const Vec2 a = skeleton.points[static_cast<std::size_t>(vertices[i - 1])].at;
    const Vec2 b = skeleton.points[static_cast<std::size_t>(vertices[i])].at;
    if (a != b) path.push_back(Edge::line(a, b));
  }
}

/// Adds the ring once round from the leg's last point, with the leg's detours in the order along the ring.
void append_ring(const Skeleton& skeleton, const Leg& leg, Path& path) {
  const Path& ring = skeleton.rings[static_cast<std::size_t>(leg.ring)];
  const auto place = [&](int point) {
    return place_on(ring, skeleton.points[static_cast<std::size_t>(point)].at);
  };
  const RingPlace start = place(leg.path_in.back());
  const auto ahead = [&](const RingPlace& p) {
    const double d = p.order() - start.order();
    return d < 0 ? d + static_cast<double>(ring.size()) : d;
  };
  std::vector<std::pair<RingPlace, const std::vector<int>*>> stops;
  for (const auto& vertices : leg.detours) stops.emplace_back(place(vertices.front()), &vertices);
  std::sort(stops.begin(), stops.end(),
            [&](const auto& a, const auto& b) { return ahead(a.first) < ahead(b.first); });
  RingPlace from = start;
  const auto append = [&](Path part) {
    if (!part.empty() && !path.empty()) part.front().from = path.back().to;
    path.insert(path.end(), part.begin(), part.end());
  };
  for (const auto& [stop, vertices] : stops) {
    if (ahead(stop) > ahead(from)) append(ring_part(ring, from, stop));
    append_lines(skeleton, *vertices, path);
    from = stop;
  }
  append(ring_part(ring, from, start));
}

}  // namespace

Skeleton skeleton_of(const std::vector<Pass>& passes, const SkeletonOptions& options) {
  return SkeletonBuilder(passes, options).build();
}

std::vector<Path> paths_of(const Skeleton& skeleton) {
  std::vector<Path> paths;
  for (const auto& leg : skeleton.legs) {
    if (leg.retracted || paths.empty()) paths.emplace_back();
    append_lines(skeleton, leg.path_in, paths.back());
    if (leg.ring >= 0) append_ring(skeleton, leg, paths.back());
  }
  return paths;
}

}  // namespace clearcut::plan::contour
