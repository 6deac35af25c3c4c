#include "plan/spiral_turn.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/units.h"
#include "geometry/boolean.h"

namespace clearcut {
namespace {

/// Greatest sweep of an arc that stands for one of changing radius.
constexpr double kBandPiece = kPi / 6;
/// mm. The turn's ends have to be found this near.
constexpr double kFound = 1e-3;
/// mm. A place of the rim this near to the loop is on it.
constexpr double kOnLoop = 2e-4;
/// The fall may end from this share of its length on, and up to so many mm after it.
constexpr double kEarliest = 0.6;
constexpr double kLatest = 1.0;
/// mm. Chords for the boolean; its arcs come back as arcs.
constexpr double kChord = 0.005;
/// Below this change of direction there is no corner.
constexpr double kNoCorner = 3 * kPi / 180;

struct OnLoop {
  std::size_t edge = 0;
  double t = 0;
  Vec2 point;
};

OnLoop nearest_on(const Loop& loop, Vec2 p) {
  OnLoop best;
  double best_distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto near = nearest(loop[i], p);
    if (near.distance >= best_distance) continue;
    best_distance = near.distance;
    best = {i, near.t, near.point};
  }
  return best;
}

Edge through(Vec2 from, Vec2 middle, Vec2 to) {
  const Vec2 chord = to - from;
  const double half = norm(chord) / 2;
  const double sagitta = dot(middle - lerp(from, to, 0.5), left_of(chord)) / (2 * half);
  if (std::abs(sagitta) < 1e-6) return Edge::line(from, to);
  return Edge::from_bulge(from, to, -sagitta / half);
}

/// The loop widened to the left by a distance that falls along it, as overlapping pieces.
class Band {
 public:
  Band(const Path& around, double widest) : widest_(widest), fall_(kSpiralFall * length(around)) {
    for (std::size_t i = 0; i < around.size() && way_ < fall_; ++i) {
      if (i > 0) add_joint(around[i - 1], around[i]);
      const double left = (fall_ - way_) / around[i].length();
      add_edge(left < 1 ? around[i].part(0, left) : around[i]);
    }
  }

  const std::vector<Loop>& pieces() const { return pieces_; }
  double fall() const { return fall_; }

 private:
  double width_at(double way) const { return widest_ * std::max(0.0, 1 - way / fall_); }

  void add_edge(const Edge& edge) {
    const int count = edge.is_arc() ? static_cast<int>(std::ceil(std::abs(edge.sweep()) / kBandPiece)) : 1;
    for (int i = 0; i < count; ++i) {
      const double t0 = static_cast<double>(i) / count, t1 = static_cast<double>(i + 1) / count;
      add_piece(count == 1 ? edge : edge.part(t0, t1));
    }
  }

  void add_piece(const Edge& edge) {
    const double begin = way_, end = way_ + edge.length();
    way_ = end;
    // Left-hand arcs narrower than the band collapse to their centre.
    const double most = edge.turn == Turn::kCounterClockwise ? edge.radius() : widest_;
    const auto inner = [&](double t) {
      return edge.at(t) + left_of(edge.tangent_at(t)) * std::min(most, width_at(begin + t * (end - begin)));
    };
    const Vec2 a = inner(0), b = inner(1);
    Loop piece{edge};
    if (distance(edge.to, b) > 1e-9) piece.push_back(Edge::line(edge.to, b));
    if (distance(a, b) > 1e-9) piece.push_back(edge.is_arc() ? through(b, inner(0.5), a) : Edge::line(b, a));
    const Vec2 last = piece.back().to;
    if (distance(last, edge.from) > 1e-9) piece.push_back(Edge::line(last, edge.from));
    piece.back().to = edge.from;
    if (piece.size() > 2 || edge.is_arc()) pieces_.push_back(std::move(piece));
  }

  void add_joint(const Edge& before, const Edge& after) {
    const double turn = cross(before.tangent_at(1), after.tangent_at(0));
    const double width = width_at(way_);
    if (turn > -1e-6 || width < 1e-6) return;
    const Vec2 east = after.from + Vec2{width, 0}, west = after.from - Vec2{width, 0};
    pieces_.push_back({Edge::arc(east, west, after.from, Turn::kCounterClockwise),
                       Edge::arc(west, east, after.from, Turn::kCounterClockwise)});
  }

  double widest_;
  double fall_;
  double way_ = 0;
  std::vector<Loop> pieces_;
};

/// The edge with other ends, near its own: arcs so small that this could turn them round become lines.
Edge between(const Edge& edge, Vec2 from, Vec2 to) {
  Edge moved = edge;
  moved.from = from;
  moved.to = to;
  if (edge.is_arc() && std::abs(moved.sweep() - edge.sweep()) > 0.1) return Edge::line(from, to);
  return moved;
}

/// Arcs shorter than the coarse chords may come out of the boolean turned round: all but a full circle.
Edge unturned(const Edge& edge) {
  const bool turned =
      edge.is_arc() && std::abs(edge.sweep()) > kPi && distance(edge.from, edge.to) < edge.radius() / 10;
  return turned ? Edge::line(edge.from, edge.to) : edge;
}

/// Way from the beginning of `path` to the place nearest to p, with the distance from it.
std::pair<double, double> way_to(const Path& path, Vec2 p) {
  double way = 0, best_way = 0, best = std::numeric_limits<double>::infinity();
  for (const auto& edge : path) {
    const auto near = nearest(edge, p);
    if (near.distance < best) {
      best = near.distance;
      best_way = way + near.t * edge.length();
    }
    way += edge.length();
  }
  return {best_way, best};
}

/// The rest of a path after `way` mm, begun exactly at `start`.
Path after(const Path& path, double way, Vec2 start) {
  Path rest;
  for (const auto& edge : path) {
    const double own = edge.length();
    if (way <= 0 || way < own - kFound) {
      const Edge piece = way > kFound ? edge.part(way / own, 1) : edge;
      rest.push_back(rest.empty() ? between(piece, start, piece.to) : piece);
    }
    way = std::max(0.0, way - own);
  }
  return rest;
}

/// The rim from `start` to where it reaches the loop, then along the loop to its end. Empty when it does so too early or
/// too late: then something came between.
Path turn_along(const Loop& rim, Vec2 start, const Path& around, double fall) {
  const auto first = std::min_element(rim.begin(), rim.end(), [&](const Edge& a, const Edge& b) {
    return distance(a.from, start) < distance(b.from, start);
  });
  if (distance(first->from, start) > kFound) return {};
  Path turn;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Edge edge = unturned(rim[(static_cast<std::size_t>(first - rim.begin()) + i) % rim.size()]);
    turn.push_back(i == 0 ? between(edge, start, edge.to) : edge);
    const auto [way, off] = way_to(around, edge.to);
    if (off > kOnLoop) continue;
    if (way < kEarliest * fall || way > fall + kLatest) return {};
    const Path rest = after(around, way, edge.to);
    turn.insert(turn.end(), rest.begin(), rest.end());
    return turn;
  }
  return {};
}

/// The remaining parts of an edge whose ends corners have taken away.
struct Trimmed {
  double begin = 0;
  double end = 1;
};

Edge offset_edge(const Edge& edge, double left) {
  if (!edge.is_arc()) {
    const Vec2 n = left_of(unit(edge.to - edge.from)) * left;
    return Edge::line(edge.from + n, edge.to + n);
  }
  const double side = edge.turn == Turn::kCounterClockwise ? -1 : 1;
  const double scale = (edge.radius() + side * left) / edge.radius();
  if (scale < 0.05) return Edge::line(edge.center, edge.center);
  return Edge::arc(edge.center + (edge.from - edge.center) * scale,
                   edge.center + (edge.to - edge.center) * scale, edge.center, edge.turn);
}

struct Fillet {
  Edge arc;
  double t_before = 1;
  double t_after = 0;
};

std::optional<Fillet> fillet(const Edge& before, const Edge& after, double radius) {
  const bool left = cross(before.tangent_at(1), after.tangent_at(0)) > 0;
  const Edge a = offset_edge(before, left ? radius : -radius),
             b = offset_edge(after, left ? radius : -radius);
  if (a.from == a.to || b.from == b.to) return std::nullopt;
  for (const Vec2 center : intersections(a, b)) {
    const auto on_before = nearest(before, center), on_after = nearest(after, center);
    if (on_before.t < 0.55 || on_after.t > 0.45 || on_before.t > 1 - 1e-6 || on_after.t < 1e-6) continue;
    if (distance(on_before.point, on_after.point) < 1e-3) continue;
    return Fillet{
        Edge::arc(on_before.point, on_after.point, center, left ? Turn::kCounterClockwise : Turn::kClockwise),
        on_before.t, on_after.t};
  }
  return std::nullopt;
}

/// The first `way` mm of a path.
Path beginning(const Path& path, double way) {
  Path first;
  for (const auto& edge : path) {
    const double own = edge.length();
    if (own >= way) {
      if (way > 1e-6) first.push_back(own - way > 1e-6 ? edge.part(0, way / own) : edge);
      break;
    }
    first.push_back(edge);
    way -= own;
  }
  return first;
}

}  // namespace

void append(Path& path, const Path& more) {
  for (const auto& edge : more) {
    const Vec2 from = path.empty() ? edge.from : path.back().to;
    if (distance(from, edge.from) > kFound) path.push_back(Edge::line(from, edge.from));
    if (path.empty() || path.back().to == edge.from) {
      path.push_back(edge);
    } else if (from != edge.to) {
      path.push_back(between(edge, from, edge.to));
    }
  }
}

Path lap(const Loop& loop, Vec2 start, double share) {
  const OnLoop at = nearest_on(loop, start);
  const Edge& edge = loop[at.edge];
  const double margin = 1e-6 / edge.length();
  const bool split = at.t > margin && at.t < 1 - margin;
  Path path;
  if (split) path.push_back(edge.part(at.t, 1));
  const std::size_t first = split || at.t >= 1 - margin ? at.edge + 1 : at.edge;
  const std::size_t whole = split ? loop.size() - 1 : loop.size();
  for (std::size_t i = 0; i < whole; ++i) path.push_back(loop[(first + i) % loop.size()]);
  if (split) path.push_back(edge.part(0, at.t));
  path.back().to = path.front().from;
  return share < 1 ? beginning(path, share * length(path)) : path;
}

Path spiral_turn(const Loop& loop, Vec2 start, const Tolerances& tol) {
  const Path around = lap(loop, start);
  const Vec2 end = around.front().from;
  const Band band(around, distance(start, end));
  Tolerances coarse = tol;
  coarse.chord = kChord;
  const bool outer = signed_area(loop) > 0;
  const Regions widened = resolve_nonzero(band.pieces(), coarse);
  const Regions bounded{Region::from_valid_loops(outer ? loop : reversed(loop), {})};
  const Regions rest = outer ? subtract(bounded, widened, coarse) : unite(bounded, widened, coarse);
  for (const auto& region : rest) {
    Path turn = turn_along(outer ? region.outer() : reversed(region.outer()), start, around, band.fall());
    if (!turn.empty()) return turn;
  }
  return {};
}

Path with_round_corners(const Path& path, double radius, const std::function<bool(Vec2)>& sharp) {
  std::vector<Trimmed> left(path.size());
  std::vector<std::optional<Edge>> arcs(path.size());
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec2 in = path[i].tangent_at(1), out = path[i + 1].tangent_at(0);
    const double turn = std::atan2(std::abs(cross(in, out)), dot(in, out));
    if (turn < kNoCorner || turn > kPi - kNoCorner || sharp(path[i].to)) continue;
    for (double r = radius; r > radius / 5; r /= 2) {
      const auto found = fillet(path[i], path[i + 1], r);
      if (!found) continue;
      arcs[i] = found->arc;
      left[i].end = found->t_before;
      left[i + 1].begin = found->t_after;
      break;
    }
  }
  Path round;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool whole = left[i].begin == 0 && left[i].end == 1;
    const Edge edge = whole ? path[i] : path[i].part(left[i].begin, left[i].end);
    const Vec2 from = round.empty() ? edge.from : round.back().to;
    round.push_back(between(edge, from, arcs[i] ? arcs[i]->from : edge.to));
    if (arcs[i]) round.push_back(*arcs[i]);
  }
  return round;
}

}  // namespace clearcut
