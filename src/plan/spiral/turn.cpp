#include "plan/spiral/turn.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/elementary.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "geometry/spatial/cell_grid.h"

namespace clearcut::plan::spiral {
namespace {

/// Radians. An arc of changing radius is replaced by arcs of at most this sweep.
constexpr double kBandPiece = kPi / 6;
/// mm. Ends nearer than this are joined by moving one of them; shorter remainders of edges are left out.
constexpr double kFound = 1e-3;
/// mm. Gaps between pieces up to this are due to rounding of the loop.
constexpr double kGap = 2e-4;
/// Sine of an angle. A piece that turns left by less does not count as farther left.
constexpr double kNoTurn = 1e-9;
/// Sine of the greatest angle at which a turn approaches the loop; a steeper one is uneven and ends in a gap.
constexpr double kSteepest = 0.95;
/// Number of cells of the index along the transition part of the turn.
constexpr double kCells = 64;
/// A turn may reach the loop from this share of the transition's length on, and up to kLatest mm after it.
constexpr double kEarliest = 0.6;
constexpr double kLatest = 1.0;
/// Radians. A smaller change of direction is no corner.
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

/// A possible piece of the rim of the loop widened to the left: beside an edge, about a corner, or the loop
/// itself.
struct RimPiece {
  Edge edge;
  bool on_loop = false;
};

/// All such pieces in the order of the loop. The widened loop is on their right.
class RimPieces {
 public:
  RimPieces(const Path& around, Vec2 start)
      : widest_(distance(start, around.front().from)),
        fall_(kSpiralFall * length(around)),
        ahead_(std::min(widest_ / fall_, kSteepest)),
        aside_(std::sqrt(1 - ahead_ * ahead_)) {
    add_joint(start, around.front().from, around.front().tangent_at(0));
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Edge& edge = around[i];
      if (i > 0 && travelled_ < fall_)
        add_joint(beside(around[i - 1], 1, travelled_), edge.from, edge.tangent_at(0));
      const double left = (fall_ - travelled_) / edge.length();
      if (left > 0) add_edge(left < 1 ? edge.part(0, left) : edge);
      if (left < 1) {
        pieces_.push_back({left > 0 ? edge.part(left, 1) : edge, true});
        travelled_ += pieces_.back().edge.length();
      }
    }
  }

  std::vector<RimPiece> take() { return std::move(pieces_); }
  double fall() const { return fall_; }

 private:
  double width_at(double travelled) const { return widest_ * std::max(0.0, 1 - travelled / fall_); }

  /// Unit vector from a place of the loop to the contact of its disc with the rim: slightly ahead, because later
  /// discs are smaller.
  Vec2 towards_rim(Vec2 heading) const { return left_of(heading) * aside_ + heading * ahead_; }

  /// The point of the rim beside the edge at t. Arcs turning left with a radius smaller than the width shrink to
  /// their centre.
  Vec2 beside(const Edge& edge, double t, double travelled) const {
    const double most = edge.turn == Turn::kCounterClockwise ? edge.radius() : widest_;
    return edge.at(t) + towards_rim(edge.tangent_at(t)) * std::min(most, width_at(travelled));
  }

  void add_edge(const Edge& edge) {
    const int count = edge.is_arc() ? static_cast<int>(std::ceil(std::abs(edge.sweep()) / kBandPiece)) : 1;
    const double begin = travelled_, whole = edge.length();
    const auto inner = [&](double t) { return beside(edge, t, begin + t * whole); };
    for (int i = 0; i < count; ++i) {
      const double t0 = static_cast<double>(i) / count, t1 = static_cast<double>(i + 1) / count;
      const Vec2 a = inner(t0), b = inner(t1);
      if (distance(a, b) < kSamePlaceMm) continue;
      pieces_.push_back({edge.is_arc() ? through(a, inner((t0 + t1) / 2), b) : Edge::line(a, b), false});
    }
    travelled_ += whole;
  }

  /// Adds the arc about a corner pointing into the area, from `from` to the beginning of the next edge's
  /// piece.
  void add_joint(Vec2 from, Vec2 corner, Vec2 heading) {
    const Vec2 to = corner + towards_rim(heading) * width_at(travelled_);
    if (cross(from - corner, to - corner) < 0 && distance(from, to) > kSamePlaceMm)
      pieces_.push_back({Edge::arc(from, to, corner, Turn::kClockwise), false});
  }

  double widest_;
  double fall_;
  double ahead_;  ///< sine of the angle between the rim and the loop
  double aside_;
  double travelled_ = 0;
  std::vector<RimPiece> pieces_;
};

/// The edge with other ends near its own; arcs so small that this could reverse them become lines.
Edge between(const Edge& edge, Vec2 from, Vec2 to) {
  Edge moved = edge;
  moved.from = from;
  moved.to = to;
  if (edge.is_arc() && std::abs(moved.sweep() - edge.sweep()) > 0.1) return Edge::line(from, to);
  return moved;
}

/// Follows the rim: along each piece up to the place where another piece is farther left, then along this other
/// piece.
class RimWalk {
 public:
  RimWalk(std::vector<RimPiece> pieces, double cell) : pieces_(std::move(pieces)), index_(cell) {
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      index_.add(pieces_[i].edge.box().grown(kSamePlaceMm), static_cast<std::uint32_t>(i));
  }

  /// The path from `start`, on the first piece, to the place where the rim reaches the loop; empty if the rim has a
  /// gap.
  Path to_loop(Vec2 start) const {
    Path path;
    std::size_t at = 0;
    Vec2 from = start;
    while (!pieces_[at].on_loop) {
      const auto step = next(at, from);
      if (!step) return {};
      if (distance(from, step->point) > kSamePlaceMm) {
        path.push_back(between(pieces_[at].edge, from, step->point));
        from = step->point;
      }
      at = step->piece;
    }
    return path;
  }

 private:
  struct Step {
    std::size_t piece = 0;
    Vec2 point;
    double travelled = std::numeric_limits<double>::infinity();  ///< mm along the piece before
    double left = 0;  ///< sine of the left turn onto the next piece there
  };

  /// The first place after `from` on piece `at` at which a later piece turns left from piece `at`, or continues it at
  /// its end.
  std::optional<Step> next(std::size_t at, Vec2 from) const {
    const Edge& edge = pieces_[at].edge;
    const double whole = edge.length(), begin = nearest(edge, from).t * whole;
    Step best;
    const auto consider = [&](std::size_t piece, Vec2 p) {
      const auto on = nearest(edge, p);
      const double travelled = on.t * whole;
      if (travelled < begin - kSamePlaceMm) return;
      const auto& other = pieces_[piece].edge;
      const double left = cross(edge.tangent_at(on.t), other.tangent_at(nearest(other, p).t));
      const bool goes_on = whole - travelled < kSamePlaceMm;
      if (left < kNoTurn && !goes_on) return;
      const bool later = travelled > best.travelled + kSamePlaceMm ||
                         (travelled > best.travelled - kSamePlaceMm && left <= best.left);
      if (best.piece == 0 || !later) best = {piece, p, travelled, left};
    };
    for (const std::uint32_t i : index_.near(edge.box().grown(kGap))) {
      if (i <= at) continue;
      if (distance(pieces_[i].edge, edge.to) < kGap) consider(i, edge.to);
      for (const Vec2 p : intersections(edge, pieces_[i].edge)) consider(i, p);
    }
    return best.piece > 0 ? std::optional(best) : std::nullopt;
  }

  std::vector<RimPiece> pieces_;
  BoxIndex index_;
};

/// The path without its first `travelled` mm; begins exactly at `start`.
Path after(const Path& path, double travelled, Vec2 start) {
  Path rest;
  for (const auto& edge : path) {
    const double own = edge.length();
    if (travelled <= 0 || travelled < own - kFound) {
      const Edge piece = travelled > kFound ? edge.part(travelled / own, 1) : edge;
      rest.push_back(rest.empty() ? between(piece, start, piece.to) : piece);
    }
    travelled = std::max(0.0, travelled - own);
  }
  return rest;
}

/// mm from the beginning of `path` to its place nearest to p.
double length_to(const Path& path, Vec2 p) {
  double travelled = 0, best_travelled = 0, best = std::numeric_limits<double>::infinity();
  for (const auto& edge : path) {
    const auto near = nearest(edge, p);
    if (near.distance < best) {
      best = near.distance;
      best_travelled = travelled + near.t * edge.length();
    }
    travelled += edge.length();
  }
  return best_travelled;
}

/// Parameters of the part of an edge left by its corners.
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

Path lap(const Loop& loop, Vec2 start) {
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
  return path;
}

SpiralTurn spiral_turn(const Loop& loop, Vec2 start) {
  const Path around = lap(loop, start);
  RimPieces pieces(around, start);
  const double fall = pieces.fall(), cell = std::max(distance(start, around.front().from), fall / kCells);
  Path turn = RimWalk(pieces.take(), cell).to_loop(start);
  if (turn.empty()) return {};
  // If the loop was reached too early or too late, another boundary was between.
  const double travelled = length_to(around, turn.back().to);
  if (travelled < kEarliest * fall || travelled > fall + kLatest) return {};
  const Path rest = after(around, travelled, turn.back().to);
  turn.insert(turn.end(), rest.begin(), rest.end());
  return {std::move(turn), travelled};
}

Path with_round_corners(const Path& path, double radius, const std::function<bool(Vec2)>& sharp) {
  std::vector<Trimmed> left(path.size());
  std::vector<std::optional<Edge>> arcs(path.size());
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec2 in = path[i].tangent_at(1), out = path[i + 1].tangent_at(0);
    const double turn = base::atan2(std::abs(cross(in, out)), dot(in, out));
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

}  // namespace clearcut::plan::spiral
