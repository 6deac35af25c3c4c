// The centre of a fillet lies `radius` to the left of both edges: where their offset lines and circles cross, nearest to the corner.
#include "read/stepnc/shapes/fillet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace clearcut::read::stepnc {
namespace {

constexpr double kCorner = 0.02;  ///< sine of the turn; less goes on smoothly
constexpr double kOnEdge = 1e-7;  // mm; touching points that are nearer to an edge's end are its end

/// What lies `radius` to the left of an edge's line or circle.
struct OffsetEdge {
  bool is_arc = false;
  Vec2 at;            ///< a point of the line; the centre of the circle
  Vec2 along;         ///< of lines, length 1
  double radius = 0;  ///< of circles
};

std::optional<OffsetEdge> offset_left(const Edge& edge, double by) {
  if (!edge.is_arc()) {
    const Vec2 along = edge.tangent_at(0);
    return OffsetEdge{false, edge.from + left_of(along) * by, along, 0};
  }
  const double radius = edge.radius() + (edge.turn == Turn::kCounterClockwise ? -by : by);
  if (radius <= kOnEdge) return std::nullopt;
  return OffsetEdge{true, edge.center, {}, radius};
}

void cross_line_circle(const OffsetEdge& line, const OffsetEdge& circle, std::vector<Vec2>& out) {
  const double along = dot(circle.at - line.at, line.along);
  const Vec2 foot = line.at + line.along * along;
  const double aside = distance(foot, circle.at);
  if (aside > circle.radius) return;
  const double half = std::sqrt(circle.radius * circle.radius - aside * aside);
  out.push_back(foot + line.along * half);
  out.push_back(foot - line.along * half);
}

void cross_circles(const OffsetEdge& a, const OffsetEdge& b, std::vector<Vec2>& out) {
  const double apart = distance(a.at, b.at);
  if (apart == 0 || apart > a.radius + b.radius || apart < std::abs(a.radius - b.radius)) return;
  const double along = (apart * apart + a.radius * a.radius - b.radius * b.radius) / (2 * apart);
  const double half = std::sqrt(std::max(0.0, a.radius * a.radius - along * along));
  const Vec2 way = (b.at - a.at) / apart;
  out.push_back(a.at + way * along + left_of(way) * half);
  out.push_back(a.at + way * along - left_of(way) * half);
}

std::vector<Vec2> crossings_of(const OffsetEdge& a, const OffsetEdge& b) {
  std::vector<Vec2> out;
  if (a.is_arc && b.is_arc) {
    cross_circles(a, b, out);
  } else if (a.is_arc) {
    cross_line_circle(b, a, out);
  } else if (b.is_arc) {
    cross_line_circle(a, b, out);
  } else if (const double turn = cross(a.along, b.along); turn != 0) {
    out.push_back(a.at + a.along * (cross(b.at - a.at, b.along) / turn));
  }
  return out;
}

/// Where an arc about `center` touches the edge's line or circle.
Vec2 touching(const Edge& edge, Vec2 center) {
  if (edge.is_arc()) return edge.center + unit(center - edge.center) * edge.radius();
  const Vec2 along = edge.tangent_at(0);
  return edge.from + along * dot(center - edge.from, along);
}

/// The part of the edge before (or after) `point`; nothing where the point does not lie on it, an edge without length where it is the
/// edge's other end.
std::optional<Edge> cut_at(const Edge& edge, Vec2 point, bool before) {
  if (distance(edge, point) > kOnEdge) return std::nullopt;
  Edge piece = edge;
  (before ? piece.to : piece.from) = point;
  if (distance(piece.from, piece.to) < kOnEdge) piece.to = piece.from = point;
  return piece;
}

bool turns_left(const Edge& a, const Edge& b) {
  return cross(a.tangent_at(1), b.tangent_at(0)) > kCorner;
}

struct Corner {
  Edge before, arc, after;
};

std::optional<Corner> round_corner(const Edge& a, const Edge& b, double radius) {
  const auto left_of_a = offset_left(a, radius), left_of_b = offset_left(b, radius);
  if (!left_of_a || !left_of_b) return std::nullopt;
  std::optional<Corner> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec2 center : crossings_of(*left_of_a, *left_of_b)) {
    const Vec2 from = touching(a, center), to = touching(b, center);
    const auto before = cut_at(a, from, true), after = cut_at(b, to, false);
    const double away = distance(center, a.to);
    if (!before || !after || away >= nearest) continue;
    nearest = away;
    best = Corner{*before, Edge::arc(from, to, center, Turn::kCounterClockwise), *after};
  }
  return best;
}

}  // namespace

Filleted filleted(const Path& path, bool closed, double radius) {
  Filleted out;
  Path edges = path;
  std::vector<std::optional<Edge>> arcs(edges.size());  // after each edge
  const std::size_t corners = closed ? edges.size() : edges.size() - std::min<std::size_t>(1, edges.size());
  for (std::size_t i = 0; i < corners; ++i) {
    Edge& a = edges[i];
    const std::size_t next = (i + 1) % edges.size();
    Edge& b = edges[next];
    if (!turns_left(path[i], path[next])) continue;
    // The fillets before may have taken an edge whole.
    const bool is_left = a.from != a.to && b.from != b.to;
    const auto corner = is_left ? round_corner(a, b, radius) : std::nullopt;
    if (!corner) {
      out.sharp.push_back(path[i].to);
      continue;
    }
    a = corner->before;
    b = corner->after;
    arcs[i] = corner->arc;
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].from != edges[i].to) out.path.push_back(edges[i]);
    if (arcs[i]) out.path.push_back(*arcs[i]);
  }
  return out;
}

Filleted filleted_on_the_right(const Path& path, double radius) {
  Filleted out = filleted(reversed(path), false, radius);
  out.path = reversed(out.path);
  return out;
}

}  // namespace clearcut::read::stepnc
