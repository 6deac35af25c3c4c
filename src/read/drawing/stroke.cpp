#include "read/drawing/stroke.h"

#include <cmath>

#include "geometry/region.h"
#include "read/common/curve_fit.h"
#include "read/repair/clean.h"

namespace clearcut::read {
namespace {

/// Sine of the turn below which two edges need no join.
constexpr double kStraight = 1e-9;

/// Collects the pieces of one pen.
class Stroker {
 public:
  explicit Stroker(const Pen& pen) : pen_(pen), half_(pen.width / 2) {}

  void draw(const Subpath& line) {
    const Path& edges = line.edges;
    if (edges.empty()) return;
    for (const Edge& edge : edges) band(edge);
    for (std::size_t i = 1; i < edges.size(); ++i) join(edges[i - 1], edges[i]);
    const bool meets = edges.front().from == edges.back().to;
    if (line.closed && !meets) {
      const Edge closing = Edge::line(edges.back().to, edges.front().from);
      band(closing);
      join(edges.back(), closing);
      join(closing, edges.front());
    } else if (line.closed) {
      join(edges.back(), edges.front());
    } else {
      cap(edges.front().from, -edges.front().tangent_at(0));
      cap(edges.back().to, edges.back().tangent_at(1));
    }
  }

  std::vector<Path> take() { return std::move(pieces_); }

 private:
  void add(Path piece) {
    if (signed_area(piece) < 0) piece = reversed(piece);
    if (signed_area(piece) > 0) pieces_.push_back(std::move(piece));
  }
  void polygon(const std::vector<Vec2>& corners) {
    Path path;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 to = corners[(i + 1) % corners.size()];
      if (corners[i] != to) path.push_back(Edge::line(corners[i], to));
    }
    add(std::move(path));
  }
  void disc(Vec2 center) { add(full_circle(center, half_)); }

  void band(const Edge& edge) {
    if (edge.is_arc()) return bent_band(edge);
    const Vec2 side = left_of(edge.tangent_at(0)) * half_;
    polygon({edge.from - side, edge.to - side, edge.to + side, edge.from + side});
  }

  /// A pen wider than the arc's diameter covers a sector, and beyond the centre another one.
  void bent_band(const Edge& arc) {
    const double inner = arc.radius() - half_, outer = arc.radius() + half_;
    if (inner > 0) {
      Path path{at_radius(arc, outer)};
      const Edge back = at_radius(arc, inner).reversed();
      path.push_back(Edge::line(path.back().to, back.from));
      path.push_back(back);
      path.push_back(Edge::line(back.to, path.front().from));
      return add(std::move(path));
    }
    sector(at_radius(arc, outer));
    if (inner < 0) sector(at_radius(arc, inner));
  }
  /// The arc about the same centre; a negative radius is on the opposite side.
  static Edge at_radius(const Edge& arc, double radius) {
    const auto at = [&](Vec2 p) { return arc.center + unit(p - arc.center) * radius; };
    return Edge::arc(at(arc.from), at(arc.to), arc.center, arc.turn);
  }
  void sector(const Edge& arc) {
    add({arc, Edge::line(arc.to, arc.center), Edge::line(arc.center, arc.from)});
  }

  void join(const Edge& before, const Edge& after) {
    const Vec2 in = before.tangent_at(1), out = after.tangent_at(0), corner = after.from;
    const double turn = cross(in, out), along = dot(in, out);
    if (std::abs(turn) < kStraight && along > 0) return;
    if (pen_.join == StrokeJoin::kRound) return disc(corner);
    const double side = turn > 0 ? -half_ : half_;
    const Vec2 a = corner + left_of(in) * side, b = corner + left_of(out) * side;
    // With t the turn, 1 / cos(t / 2) is the miter's length over the pen's width.
    const double cosine = std::sqrt(std::max(0.0, (1 + along) / 2));
    if (pen_.join == StrokeJoin::kMiter && cosine * pen_.miter_limit >= 1) {
      polygon({corner, a, corner + unit((a - corner) + (b - corner)) * (half_ / cosine), b});
    } else {
      polygon({corner, a, b});
    }
  }

  void cap(Vec2 end, Vec2 outwards) {
    if (pen_.cap == StrokeCap::kRound) return disc(end);
    if (pen_.cap == StrokeCap::kSquare) band(Edge::line(end, end + outwards * half_));
  }

  const Pen pen_;
  const double half_;
  std::vector<Path> pieces_;
};

}  // namespace

std::vector<Path> stroke_pieces(const std::vector<Subpath>& lines, const Pen& pen) {
  Stroker stroker(pen);
  for (const Subpath& line : lines) stroker.draw(line);
  return stroker.take();
}

std::vector<Path> stroke_pieces(const Affine& map, Pen pen,
                                const std::function<std::vector<Subpath>(const Affine&)>& lines) {
  if (map.is_similarity()) {
    pen.width *= std::sqrt(std::abs(map.determinant()));
    return stroke_pieces(lines(map), pen);
  }
  std::vector<Path> pieces;
  for (const Path& drawn : stroke_pieces(lines(Affine{}), pen)) {
    Path piece;
    for (const Edge& edge : map.mirrors() ? reversed(drawn) : drawn)
      append_mapped(edge, map, kCurveTolerance, piece);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace clearcut::read
