#include "plan/common/mend.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/units.h"
#include "plan/common/cover.h"

namespace clearcut::plan {
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
