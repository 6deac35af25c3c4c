#include "plan/common/residual.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "base/units.h"
#include "plan/common/cover.h"

namespace clearcut::plan {
namespace {

/// mm. Residuals thinner than this are due to rounding.
constexpr double kNothing = 1e-6;
/// mm. A path deviating from its contour by less than this clears no significant material.
constexpr double kTooShort = 0.003;

/// A place to be cleared by a cutter at a vertex, with all points within `around` mm of the place.
struct Served {
  Vec2 point;
  double around = 0;
};

struct Link {
  std::size_t a = 0;
  std::size_t b = 0;
  bool gone = false;    ///< the places reached by this link are cleared from elsewhere
  bool walked = false;  ///< already part of a path
};

/// The part of the medial axis to be followed, as a graph trimmed from its free ends.
class ResidualGraph {
 public:
  ResidualGraph(const RingNode& node, double radius) : radius_(radius) {
    const double from = node.level + radius + kNothing;
    for (const auto& piece : node.gap) {
      if (piece.high.clearance > from) add(piece, from, node);
    }
  }

  std::vector<ResidualPath> paths() {
    prune();
    std::vector<ResidualPath> found;
    for (const std::size_t start : starts()) {
      if (visited_[start]) continue;
      auto path = walk_from(start);
      if (!path.rooted || reaches_far(path)) found.push_back(std::move(path));
    }
    return found;
  }

 private:
  static bool reaches_far(const ResidualPath& path) {
    return std::any_of(path.points.begin(), path.points.end(),
                       [&](Vec2 p) { return distance(p, path.points.front()) > kTooShort; });
  }

  void add(AxisPiece piece, double from, const RingNode& node) {
    int low_id = piece.low_id;
    if (piece.low.clearance < from) {
      const double t = (from - piece.low.clearance) / (piece.high.clearance - piece.low.clearance);
      piece.low = {lerp(piece.low.point, piece.high.point, t), from};
      low_id = next_tip_--;
    }
    const std::size_t a = vertex(low_id, piece.low.point);
    const std::size_t b = vertex(piece.high_id, piece.high.point);
    root_[b] = root_[b] || (piece.high_id < 0 && piece.high.clearance >= node.next_level);
    if (a == b) return;  // the lone centre of a round pocket
    // A residual is at most this far from its place on the axis. At centres of fillets more than two walls
    // contribute to one place.
    served_[a].front().around = piece.low.clearance - from;
    served_[b].front().around = piece.high.clearance - from;
    links_at_[a].push_back(links_.size());
    links_at_[b].push_back(links_.size());
    links_.push_back({a, b});
  }

  std::size_t vertex(int id, Vec2 point) {
    const auto [it, added] = index_.emplace(id, place_.size());
    if (added) {
      place_.push_back(point);
      root_.push_back(false);
      visited_.push_back(false);
      links_at_.emplace_back();
      served_.push_back({{point, 0.0}});
    }
    return it->second;
  }

  std::size_t copy_of(std::size_t v) {
    place_.push_back(Vec2(place_[v]));
    root_.push_back(false);
    visited_.push_back(true);
    links_at_.emplace_back();
    served_.emplace_back();
    return place_.size() - 1;
  }

  std::size_t degree(std::size_t v) const {
    return static_cast<std::size_t>(std::count_if(links_at_[v].begin(), links_at_[v].end(),
                                                  [&](std::size_t i) { return !links_[i].gone; }));
  }

  std::size_t other_end(std::size_t link, std::size_t v) const {
    return links_[link].a == v ? links_[link].b : links_[link].a;
  }

  /// Cuts free ends back as far as a cutter standing there still clears everything beyond.
  void prune() {
    std::vector<std::size_t> free_ends;
    for (std::size_t v = 0; v < place_.size(); ++v) {
      if (!root_[v] && degree(v) == 1) free_ends.push_back(v);
    }
    for (std::size_t next = 0; next < free_ends.size(); ++next) {
      const std::size_t v = free_ends[next];
      if (degree(v) != 1) continue;
      const std::size_t u = shorten(v);
      if (u != v && !root_[u] && degree(u) == 1) free_ends.push_back(u);
    }
  }

  /// Moves the free end v inwards. Returns v, or the next vertex if v's whole link was cut off.
  std::size_t shorten(std::size_t v) {
    const std::size_t link = *std::find_if(links_at_[v].begin(), links_at_[v].end(),
                                           [&](std::size_t i) { return !links_[i].gone; });
    const std::size_t u = other_end(link, v);
    double t = 1;
    for (const Served& p : served_[v]) t = std::min(t, reach(place_[v], place_[u], p));
    if (t < 1) {
      place_[v] = lerp(place_[v], place_[u], t);
      return v;
    }
    links_[link].gone = true;
    visited_[v] = true;
    served_[u].insert(served_[u].end(), served_[v].begin(), served_[v].end());
    return u;
  }

  /// The largest t <= 1 such that a cutter at from + t (to - from) clears p.
  double reach(Vec2 from, Vec2 to, const Served& p) const {
    const Vec2 d = to - from, s = from - p.point;
    const double far = std::max(0.0, radius_ - p.around);
    const double a = norm_squared(d), b = dot(d, s), c = norm_squared(s) - far * far;
    if (a <= 0) return 1;
    const double root = std::sqrt(std::max(0.0, b * b - a * c));
    return std::clamp((root - b) / a, 0.0, 1.0);
  }

  /// Possible starts of paths: roots, else free ends, else any vertex. A root with all links removed needs no path.
  std::vector<std::size_t> starts() {
    std::vector<std::size_t> roots, ends, others;
    for (std::size_t v = 0; v < place_.size(); ++v) {
      const std::size_t links = degree(v);
      if (root_[v] && links == 0) visited_[v] = true;
      (root_[v] ? roots : links == 1 ? ends : others).push_back(v);
    }
    roots.insert(roots.end(), ends.begin(), ends.end());
    roots.insert(roots.end(), others.begin(), others.end());
    return roots;
  }

  ResidualPath walk_from(std::size_t start) {
    ResidualPath path;
    path.rooted = root_[start];
    if (ring_from(start, path)) return path;
    measure_from(start);
    visit(start, path.points);
    // The path runs there and back. The last return is needed only if the path must end on its root.
    if (!path.rooted) path.points.resize(last_new_);
    return path;
  }

  /// Whether `start` is on a simple cycle with two links at every vertex; if so, fills `path`.
  bool ring_from(std::size_t start, ResidualPath& path) {
    std::vector<std::size_t> ring;
    std::size_t v = start, came_by = links_.size();
    do {
      if (degree(v) != 2) return false;
      ring.push_back(v);
      const auto& at = links_at_[v];
      came_by =
          *std::find_if(at.begin(), at.end(), [&](std::size_t i) { return !links_[i].gone && i != came_by; });
      v = other_end(came_by, v);
    } while (v != start);
    for (const std::size_t i : ring) {
      visited_[i] = true;
      path.points.push_back(place_[i]);
    }
    path.closed = true;
    return true;
  }

  /// Orders the vertices depth first, the longest branch last. Without recursion, because axes may be long.
  void measure_from(std::size_t start) {
    // Everything connected with `start` is walked here, once: earlier walks were elsewhere, and their entries may stay.
    children_.resize(place_.size());
    length_.resize(place_.size(), 0);
    seen_.resize(place_.size(), false);
    std::vector<std::size_t> order{start};
    seen_[start] = true;
    for (std::size_t next = 0; next < order.size(); ++next) {
      const std::size_t v = order[next];
      for (std::size_t i = 0; i < links_at_[v].size(); ++i) {
        Link& link = links_[links_at_[v][i]];
        if (link.gone || link.walked) continue;
        link.walked = true;
        std::size_t u = other_end(links_at_[v][i], v);
        if (seen_[u]) {
          u = copy_of(u);  // the link closes a cycle: this link is followed from here as a dead end
          children_.emplace_back();
          length_.push_back(0);
          seen_.push_back(true);
        } else {
          seen_[u] = true;
          order.push_back(u);
        }
        children_[v].push_back(u);
      }
    }
    for (auto v = order.rbegin(); v != order.rend(); ++v) {
      auto& below = children_[*v];
      const auto beyond = [&](std::size_t u) { return length_[u] + distance(place_[*v], place_[u]); };
      std::sort(below.begin(), below.end(),
                [&](std::size_t a, std::size_t b) { return beyond(a) < beyond(b); });
      if (!below.empty()) length_[*v] = beyond(below.back());
    }
  }

  void visit(std::size_t start, std::vector<Vec2>& points) {
    std::vector<std::pair<std::size_t, std::size_t>> stack{{start, 0}};
    enter(start, points);
    while (!stack.empty()) {
      const std::size_t v = stack.back().first;
      if (stack.back().second < children_[v].size()) {
        const std::size_t u = children_[v][stack.back().second++];
        enter(u, points);
        stack.push_back({u, 0});
      } else {
        stack.pop_back();
        if (!stack.empty()) points.push_back(place_[stack.back().first]);
      }
    }
  }

  void enter(std::size_t v, std::vector<Vec2>& points) {
    visited_[v] = true;
    points.push_back(place_[v]);
    last_new_ = points.size();
  }

  double radius_;
  int next_tip_ = -1'000'000'000;  // less than every number given by ring_tree
  std::map<int, std::size_t> index_;
  std::vector<Vec2> place_;
  std::vector<bool> root_;
  std::vector<bool> visited_;
  std::vector<std::vector<std::size_t>> links_at_;
  std::vector<std::vector<Served>> served_;
  std::vector<Link> links_;
  std::vector<std::vector<std::size_t>> children_;
  std::vector<double> length_;  ///< mm; of the longest branch below a walked vertex
  std::vector<bool> seen_;      ///< by a walk
  std::size_t last_new_ = 0;
};

}  // namespace

std::vector<ResidualPath> residual_paths(const RingNode& node, double radius) {
  return ResidualGraph(node, radius).paths();
}

namespace {

constexpr int kRounds = 24;
/// mm. Detours go this much farther than they have to, against rounding.
constexpr double kReserve = 2e-4;
/// Share of the radius. Vertices of holes within this of one centre are cleared by one detour.
constexpr double kGroup = 0.7;
/// Radians. Arcs wider than the cutter are checked in pieces of at most this sweep.
constexpr double kArcPiece = kPi / 9;
/// Share of an edge's length. A detour that begins nearer than this to an end of the edge begins at that end.
constexpr double kAtEnd = 1e-6;

/// Vertices of holes, and the cutter position clearing them.
struct Group {
  std::vector<Vec2> points;
  Vec2 center;
};

/// Adds the path's edges, arcs wider than the cutter in pieces: a hole inside such an arc then has vertices.
void append(const Path& path, double radius, std::vector<Edge>& edges) {
  for (const auto& edge : path) {
    const bool wide = edge.is_arc() && edge.radius() > radius;
    const int count = wide ? static_cast<int>(std::ceil(std::abs(edge.sweep()) / kArcPiece)) : 1;
    Vec2 from = edge.from;
    for (int i = 0; i < count; ++i) {
      Edge piece = edge;
      piece.from = from;
      if (i + 1 < count) piece.to = edge.at(static_cast<double>(i + 1) / count);
      from = piece.to;
      edges.push_back(piece);
    }
  }
}

std::vector<Edge> all_edges(std::span<const Path> paths, const MendJob& job) {
  std::vector<Edge> edges;
  append({job.fixed.begin(), job.fixed.end()}, job.radius, edges);
  for (const auto& path : paths) append(path, job.radius, edges);
  return edges;
}

/// Groups the vertices greedily: each joins the nearest group whose box then has a diagonal of at most 2 `most` mm.
std::vector<Group> groups_of(std::vector<Vec2> holes, double most) {
  std::sort(holes.begin(), holes.end(), [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Group> groups;
  std::vector<Box> boxes;
  for (const Vec2 p : holes) {
    std::size_t best = groups.size();
    double best_distance = 2 * most;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      Box grown = boxes[i];
      grown.add(p);
      const double d = distance(boxes[i].center(), p);
      if (norm(grown.max - grown.min) > 2 * most || d >= best_distance) continue;
      best = i;
      best_distance = d;
    }
    if (best == groups.size()) {
      groups.emplace_back();
      boxes.emplace_back();
    }
    groups[best].points.push_back(p);
    boxes[best].add(p);
  }
  for (std::size_t i = 0; i < groups.size(); ++i) groups[i].center = boxes[i].center();
  return groups;
}

/// Share of the line from `from` to the group's centre that the cutter must travel to clear the whole group.
double share_to_go(Vec2 from, const Group& group, double radius) {
  const Vec2 offset = group.center - from;
  const double length_squared = norm_squared(offset);
  double share = 0;
  for (const Vec2 p : group.points) {
    // The smaller root t of |from + t offset - p| = radius.
    const Vec2 off = from - p;
    const double b = dot(off, offset), c = norm_squared(off) - radius * radius;
    if (c <= 0 || length_squared <= 0) continue;
    const double root = b * b - length_squared * c;
    share = std::max(share, root > 0 ? std::clamp((-b - std::sqrt(root)) / length_squared, 0.0, 1.0) : 1.0);
  }
  return share;
}

struct Place {
  std::size_t path = 0;
  std::size_t edge = 0;
  double t = 0;
  Vec2 point;
  double distance = std::numeric_limits<double>::infinity();
};

/// Possible starts of a detour to p: the place nearest to p on each edge, the nearest first.
std::vector<Place> places_near(const std::vector<Path>& paths, Vec2 p, double reach) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    for (std::size_t k = 0; k < paths[i].size(); ++k) {
      if (paths[i][k].box().distance_to(p) > reach) continue;
      const auto near = nearest(paths[i][k], p);
      if (near.distance <= reach) places.push_back({i, k, near.t, near.point, near.distance});
    }
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.distance < b.distance; });
  return places;
}

/// Inserts the detour to `target` and back. At a free end of the path the detour needs no return.
void insert_path(Path& path, const Place& place, Vec2 target) {
  const Edge edge = path[place.edge];
  const bool at_from = place.t<kAtEnd, at_to = place.t> 1 - kAtEnd;
  const Vec2 q = at_from ? edge.from : at_to ? edge.to : place.point;
  const auto at = path.begin() + static_cast<std::ptrdiff_t>(place.edge);
  if (at_from && place.edge == 0 && path.front().from != path.back().to) {
    path.insert(path.begin(), Edge::line(target, q));
    return;
  }
  if (at_to && place.edge + 1 == path.size() && path.front().from != path.back().to) {
    path.push_back(Edge::line(q, target));
    return;
  }
  const Path there{Edge::line(q, target), Edge::line(target, q)};
  if (at_from || at_to) {
    path.insert(at_from ? at : at + 1, there.begin(), there.end());
    return;
  }
  Path pieces{edge.part(0, place.t), there[0], there[1], edge.part(place.t, 1)};
  pieces[0].to = pieces[3].from = q;
  const auto next = path.erase(at);
  path.insert(next, pieces.begin(), pieces.end());
}

bool clear_group(std::vector<Path>& paths, const Group& group, const MendJob& job) {
  const double radius = job.radius + std::min(0.0, job.residual) - kReserve;
  for (const auto& place : places_near(paths, group.center, 4 * job.radius)) {
    const double share = share_to_go(place.point, group, radius);
    const Vec2 target = lerp(place.point, group.center, share);
    if (distance(place.point, target) < 1e-6) continue;
    if (!job.legal(place.point, target)) continue;
    insert_path(paths[place.path], place, target);
    return true;
  }
  return false;
}

}  // namespace

std::vector<Vec2> left_by(std::span<const Path> paths, const MendJob& job) {
  return Cover(all_edges(paths, job), job.radius + job.residual).holes(job.matters);
}

bool mend(std::vector<Path>& paths, const MendJob& job) {
  double most = kGroup * job.radius;
  for (int round = 0; round < kRounds; ++round) {
    const auto holes = left_by(paths, job);
    if (holes.empty()) return true;
    bool any = false;
    for (const auto& group : groups_of(holes, most)) any |= clear_group(paths, group, job);
    if (!any) return false;
    if (round == kRounds / 3) most /= 2;
  }
  return left_by(paths, job).empty();
}

}  // namespace clearcut::plan
