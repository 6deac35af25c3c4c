#include "link/access_paths.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/tolerances.h"

namespace clearcut::link {
namespace {

/// mm by which a cutter may be wider than a predrilled hole.
constexpr double kHoleSlack = 0.001;
/// Seconds. Longer access paths round corners are used only for cutters that must not plunge.
constexpr double kLongestAccess = 5;
/// Greatest number of places on the rim of cleared stock that are tried.
constexpr std::size_t kMostPlaces = 32;
/// Greatest number of places on a ring that are tried as its beginning.
constexpr std::size_t kMostStarts = 8;

/// Points `apart` mm beside the stock, square to its sides from p.
std::array<Vec2, 4> places_beside(const Box& stock, double apart, Vec2 p) {
  const Box beyond = stock.grown(apart);
  return {Vec2{beyond.min.x, p.y}, {beyond.max.x, p.y}, {p.x, beyond.min.y}, {p.x, beyond.max.y}};
}

}  // namespace

bool AccessPaths::is_clear(std::size_t item, Vec2 a, Vec2 b) const {
  return is_free(item, Edge::line(a, b)) && layer(item).legal().holds_line(a, b);
}

bool AccessPaths::is_free(std::size_t item, const Edge& path) const {
  const std::size_t at = work_.items()[item].layer;
  return progress_.clear_above(at, path.box()) && cleared_.is_clear(at, path);
}

bool AccessPaths::in_air(Vec2 p) const {
  if (options_.stock && options_.stock->distance_to(p) >= beside_stock() - kRoundingMm) return true;
  return std::any_of(options_.predrilled.begin(), options_.predrilled.end(), [&](const PredrilledHole& hole) {
    return distance(p, hole.center) + options_.tool_radius <= hole.diameter / 2 + kHoleSlack;
  });
}

std::optional<PassStart> AccessPaths::start_before_air(std::size_t item) const {
  const Path& path = work_.pass(item).path;
  for (std::size_t i = 0; i < path.size(); ++i) {
    for (const double t : {0.5, 0.0}) {
      const PassStart start{path[i].at(t), i, t, false};
      if (air_before(start.point, item)) return start;
    }
  }
  return std::nullopt;
}

std::optional<PassStart> AccessPaths::start_before_cleared(std::size_t item) const {
  const Path& path = work_.pass(item).path;
  const std::size_t step = path.size() / kMostStarts + 1;
  for (std::size_t i = 0; i < path.size(); i += step) {
    const PassStart start{path[i].at(0.5), i, 0.5, false};
    if (cleared_before(start.point, item)) return start;
  }
  return std::nullopt;
}

std::optional<PassStart> AccessPaths::start_on_access_path(const PassStart& start, std::size_t item) const {
  const auto path = to(start.point, item);
  if (!path) return std::nullopt;
  const Path& ring = work_.pass(item).path;
  for (const Edge& edge : *path) {
    std::optional<PassStart> first;
    double nearest_t = 1;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      for (const Vec2 p : intersections(edge, ring[i])) {
        const double t = nearest(edge, p).t;
        if (first && t >= nearest_t) continue;
        nearest_t = t;
        first = PassStart{p, i, nearest(ring[i], p).t, false};
      }
    }
    if (first) return first;
  }
  return start;
}

/// The nearest predrilled hole with a straight legal move to p.
std::optional<Vec2> AccessPaths::hole_before(Vec2 p, std::size_t item) const {
  std::optional<Vec2> best;
  for (const PredrilledHole& hole : options_.predrilled) {
    if (!in_air(hole.center) || (best && distance(p, hole.center) >= distance(p, *best))) continue;
    if (is_clear(item, hole.center, p)) best = hole.center;
  }
  return best;
}

std::optional<Vec2> AccessPaths::air_before(Vec2 p, std::size_t item) const {
  if (in_air(p)) return p;
  if (const auto hole = hole_before(p, item)) return hole;
  if (!options_.stock || !layer(item).open()) return std::nullopt;
  std::optional<Vec2> best;
  for (const Vec2 out : places_beside(*options_.stock, beside_stock(), p)) {
    if (best && distance(p, out) >= distance(p, *best)) continue;
    if (is_clear(item, out, p)) best = out;
  }
  return best;
}

std::optional<Vec2> AccessPaths::cleared_before(Vec2 p, std::size_t item) const {
  if (!options_.may_plunge || !layer(item).open()) return std::nullopt;
  for (const Vec2 place : layer(item).nearest_on_rim(p, kMostPlaces)) {
    if (is_clear(item, place, p)) return place;
  }
  return std::nullopt;
}

/// The path round corners from `from`, a place in the air, beginning at its last exit from the air.
std::optional<Path> AccessPaths::path_round(Vec2 from, Vec2 to, std::size_t item) const {
  const LayerWork& where = layer(item);
  if (!where.legal().holds(from)) return std::nullopt;
  auto path = where.routes().between(from, to);
  if (!path || path->empty()) return std::nullopt;
  while (path->size() > 1 && in_air(path->front().to)) path->erase(path->begin());
  const auto may_be_run = [&](const Edge& edge) {
    return (edge.is_arc() || where.legal().holds_line(edge.from, edge.to)) && is_free(item, edge);
  };
  if (!std::all_of(path->begin(), path->end(), may_be_run)) return std::nullopt;
  return path;
}

std::optional<Path> AccessPaths::to(Vec2 p, std::size_t item) const {
  if (const auto air = air_before(p, item)) return *air == p ? Path{} : Path{Edge::line(*air, p)};
  if (const auto beside = cleared_before(p, item))
    return *beside == p ? Path{} : Path{Edge::line(*beside, p)};
  if (!cleared_.is_clear(work_.items()[item].layer, Edge::line(p, p))) return std::nullopt;
  std::vector<Vec2> outs;
  for (const PredrilledHole& hole : options_.predrilled) {
    if (in_air(hole.center)) outs.push_back(hole.center);
  }
  if (options_.stock && layer(item).open()) {
    for (const Vec2 out : places_beside(*options_.stock, beside_stock(), p)) outs.push_back(out);
  }
  // The nearest first: places farther away than a path that was found are not asked.
  std::stable_sort(outs.begin(), outs.end(), [&](Vec2 a, Vec2 b) { return distance(a, p) < distance(b, p); });
  std::optional<Path> best;
  double longest = options_.may_plunge
                       ? kLongestAccess * options_.lead_feed.value_or(options_.feed).mm_per_s()
                       : std::numeric_limits<double>::infinity();
  for (const Vec2 out : outs) {
    if (distance(out, p) >= longest) break;
    auto path = path_round(out, p, item);
    if (!path || length(*path) >= longest) continue;
    longest = length(*path);
    best = std::move(path);
  }
  return best;
}

}  // namespace clearcut::link
