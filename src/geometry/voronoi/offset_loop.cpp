#include "geometry/voronoi/offset_loop.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace clearcut::voronoi {
namespace {

double fast_norm(Vec2 a) {
  return std::sqrt(norm_squared(a));
}

/// mm. Below this a turn of the boundary leaves no arc worth writing: the two offset curves meet in one
/// point.
constexpr double kSmooth = 2e-4;
/// mm. Joints nearer than this are one.
constexpr double kCoincident = 1e-7;
/// mm. Ends this near to an offset curve are on it.
constexpr double kOnCurve = 1e-9;

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double length_squared = norm_squared(d);
  const double t = length_squared > 0 ? std::clamp(dot(p - a, d) / length_squared, 0.0, 1.0) : 0.0;
  return fast_norm(p - (a + d * t));
}

class Assembler {
 public:
  Assembler(const Diagram& diagram, const LevelCurve& curve, double d, double slack)
      : diagram_(diagram), d_(d), slack_(slack), pieces_(curve.pieces) {}

  std::optional<Loop> run() {
    if (pieces_.size() == 1) return full_circle();
    drop_shrunken_arcs();
    mend_corners();
    if (pieces_.size() < 2) return std::nullopt;
    solve_joints();
    while (drop_reversed()) {
      if (pieces_.size() < 2) return std::nullopt;
    }
    return emit();
  }

 private:
  const Element& element(const Piece& piece) const { return diagram_.element(piece.element); }
  Piece& piece(std::size_t i) { return pieces_[i % pieces_.size()]; }

  /// Removes piece i; the piece after it starts in the middle of what was there.
  void drop(std::size_t i) {
    Piece& after = piece(i + 1);
    const Piece& gone = piece(i);
    after.low = gone.guess;
    after.high = after.guess;
    after.at_node = false;
    after.mended = true;
    after.guess = lerp(gone.guess, after.guess, 0.5);
    pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  void merge_equal_neighbours() {
    for (std::size_t i = 0; pieces_.size() > 1 && i < pieces_.size();) {
      if (piece(i).element == piece(i + pieces_.size() - 1).element) {
        // The piece before goes on: what starts here is its inside.
        pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        ++i;
      }
    }
  }

  /// Whether neighbours that go on to meet without the arc stay within the slack of it.
  bool is_shrunken(const Element& arc) const {
    const double left = arc.radius - d_, half = std::abs(arc.edge.sweep()) / 2;
    if (left <= kCoincident) return true;
    return left < slack_ && half < kPi / 2 && left * (1 / std::cos(half) - 1) < slack_ / 2;
  }

  /// Concave arcs whose offset has (almost) shrunk to their centre.
  void drop_shrunken_arcs() {
    bool dropped = false;
    for (std::size_t i = 0; i < pieces_.size();) {
      const Element& e = element(pieces_[i]);
      if (e.wall == Wall::kConcave && is_shrunken(e)) {
        drop(i);
        dropped = true;
      } else {
        ++i;
      }
    }
    if (dropped) merge_equal_neighbours();
  }

  /// Distance between the offsets of two edges at their common vertex, > 0 where an arc about it joins them.
  double opening(const Edge& before, const Edge& after) const {
    const Vec2 a = before.tangent_at(1), b = after.tangent_at(0);
    return -d_ * std::atan2(cross(a, b), dot(a, b));
  }

  bool are_neighbours(const Element& a, const Element& b) const {
    return !a.is_point() && !b.is_point() && a.edge.to == b.edge.from;
  }

  /// Place of the offset beside the vertex where edge b follows edge a.
  Vec2 beside_vertex(const Element& a, const Element& b) const {
    const Vec2 n = left_of(a.edge.tangent_at(1)) + left_of(b.edge.tangent_at(0));
    return a.edge.to + n * (d_ / fast_norm(n));
  }

  /// The chords of arcs may turn a vertex the wrong way: decided here by the exact tangents.
  void mend_corners() {
    drop_false_vertices();
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const Element &a = element(piece(i + pieces_.size() - 1)), &b = element(piece(i));
      if (!are_neighbours(a, b)) continue;
      const double wide = opening(a.edge, b.edge);
      // The chords hide a turn of at most half a step each: a wider one has its own cell in the diagram.
      if (wide <= kSmooth || wide > d_ * kPi / 2 || !starts_beside_vertex(i)) continue;
      insert_vertex(i);
      ++i;
    }
  }

  void drop_false_vertices() {
    bool dropped = false;
    for (std::size_t i = 0; pieces_.size() > 2 && i < pieces_.size();) {
      const Element &a = element(piece(i + pieces_.size() - 1)), &v = element(piece(i)),
                    &b = element(piece(i + 1));
      if (v.is_point() && are_neighbours(a, b) && a.edge.to == v.edge.from &&
          opening(a.edge, b.edge) <= kSmooth) {
        drop(i);
        dropped = true;
      } else {
        ++i;
      }
    }
    if (dropped) merge_equal_neighbours();
  }

  /// Whether the joint before piece i lies beside the common vertex and not where the two edges meet again.
  bool starts_beside_vertex(std::size_t i) {
    const Piece& here = piece(i);
    const Element &a = element(piece(i + pieces_.size() - 1)), &b = element(here);
    const double to_vertex = fast_norm(here.guess - beside_vertex(a, b));
    const auto met = meeting_near(offset_curve(a, d_), offset_curve(b, d_), here.guess, slack_);
    return !met || to_vertex <= fast_norm(*met - here.guess) + opening(a.edge, b.edge);
  }

  void insert_vertex(std::size_t i) {
    const Element &a = element(piece(i + pieces_.size() - 1)), &b = element(piece(i));
    const Vec2 v = a.edge.to;
    const Vec2 start = v + left_of(a.edge.tangent_at(1)) * d_, end = v + left_of(b.edge.tangent_at(0)) * d_;
    const Piece arc{a.end_vertex, start, start, start, false, false};
    piece(i).guess = piece(i).low = piece(i).high = end;
    piece(i).at_node = false;
    pieces_.insert(pieces_.begin() + static_cast<std::ptrdiff_t>(i), arc);
  }

  /// One element all round: an island that is a point, or an arc that is all but closed. Others are an
  /// accident of rounding about an arc's centre.
  std::optional<Loop> full_circle() const {
    const Element& only = element(pieces_[0]);
    if (only.edge.is_arc() && std::abs(only.edge.sweep()) < 1.9 * kPi) return std::nullopt;
    const OffsetCurve circle = offset_curve(only, d_);
    if (circle.straight || circle.radius <= kCoincident) return std::nullopt;
    const Vec2 a = circle.point - Vec2{circle.radius, 0}, b = circle.point + Vec2{circle.radius, 0};
    return Loop{Edge::arc(a, b, circle.point, circle.turn), Edge::arc(b, a, circle.point, circle.turn)};
  }

  void solve_joints() {
    joints_.resize(pieces_.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i) joints_[i] = solve_joint(i);
  }

  Vec2 solve_joint(std::size_t i) {
    const Piece& here = piece(i);
    const Element &a = element(piece(i + pieces_.size() - 1)), &b = element(here);
    if (b.is_point() && !a.is_point() && a.edge.to == b.edge.from) {
      return a.edge.to + left_of(a.edge.tangent_at(1)) * d_;
    }
    if (a.is_point() && !b.is_point() && b.edge.from == a.edge.from) {
      return b.edge.from + left_of(b.edge.tangent_at(0)) * d_;
    }
    if (are_neighbours(a, b) && std::abs(opening(a.edge, b.edge)) <= kSmooth && starts_beside_vertex(i)) {
      return beside_vertex(a, b);
    }
    const auto met = meeting_near(offset_curve(a, d_), offset_curve(b, d_), here.guess, slack_);
    return met && distance_to_segment(*met, here.low, here.high) <= reach(here) ? *met : here.guess;
  }

  /// How far from its bisector's ends a joint may lie.
  double reach(const Piece& here) const {
    if (here.at_node) return slack_;
    // Sites within some error of an arc turn from it by up to the root of that.
    const double root = here.mended ? 2 * std::sqrt(diagram_.sites.error * d_) : 0;
    return 0.5 * fast_norm(here.high - here.low) + 20 * slack_ + root;
  }

  Vec2 joint(std::size_t i) const { return joints_[i % joints_.size()]; }

  /// A piece that would run against its direction exists in the diagram only: its neighbours meet without it.
  bool drop_reversed() {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (!runs_backwards(i)) continue;
      drop(i);
      merge_equal_neighbours();
      if (!pieces_.empty()) solve_joints();
      return true;
    }
    return false;
  }

  bool runs_backwards(std::size_t i) {
    const OffsetCurve curve = offset_curve(element(piece(i)), d_);
    if (curve.straight) return dot(joint(i + 1) - joint(i), curve.direction) < -kCoincident;
    // The offset of an arc turns no farther than the arc, that of a vertex no farther than half round. An arc
    // that runs a little backwards seems to go nearly all round instead.
    const Edge& source = element(piece(i)).edge;
    const double most = source.is_arc() ? std::abs(source.sweep()) : kPi;
    const Edge arc = Edge::arc(joint(i), joint(i + 1), curve.point, curve.turn);
    return arc.from != arc.to && std::abs(arc.sweep()) > (most + 2 * kPi) / 2;
  }

  std::optional<Loop> emit() {
    Loop loop;
    loop.reserve(pieces_.size());
    Vec2 from = joint(0);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const bool last = i + 1 == pieces_.size();
      Vec2 to = joint(i + 1);
      if (last && !loop.empty()) to = loop.front().from;
      if (fast_norm(to - from) <= kCoincident) {
        if (last && !loop.empty()) close(loop, to);
        continue;
      }
      loop.push_back(exact_edge(offset_curve(element(piece(i)), d_), from, to));
      from = to;
    }
    if (loop.size() < 2) return std::nullopt;
    return loop;
  }

  /// Moves the end of the last edge by less than kCoincident.
  static void close(Loop& loop, Vec2 to) { loop.back() = fitted(loop.back(), to); }

  static Edge fitted(Edge edge, Vec2 to) {
    edge.to = to;
    return edge.is_arc() ? centred(edge) : edge;
  }

  /// An arc's centre moved along its chord until both ends are equally far; a line where no arc is left.
  static Edge centred(Edge arc) {
    const Vec2 chord = arc.to - arc.from;
    const double excess = norm_squared(arc.from - arc.center) - norm_squared(arc.to - arc.center);
    const Vec2 shift = chord * (-excess / (2 * norm_squared(chord)));
    if (norm_squared(shift) > norm_squared(chord) && norm_squared(shift) > 1e-12)
      return Edge::line(arc.from, arc.to);
    arc.center = arc.center + shift;
    return arc;
  }

  static Edge exact_edge(const OffsetCurve& curve, Vec2 from, Vec2 to) {
    if (curve.straight) return Edge::line(from, to);
    const Edge arc = Edge::arc(from, to, curve.point, curve.turn);
    const double off_from = std::abs(fast_norm(from - curve.point) - curve.radius);
    const double off_to = std::abs(fast_norm(to - curve.point) - curve.radius);
    return off_from <= kOnCurve && off_to <= kOnCurve ? arc : centred(arc);
  }

  const Diagram& diagram_;
  double d_;
  double slack_;
  std::vector<Piece> pieces_;
  std::vector<Vec2> joints_;
};

}  // namespace

std::optional<Loop> offset_loop(const Diagram& diagram, const LevelCurve& curve, double d, double slack) {
  return Assembler(diagram, curve, d, slack).run();
}

}  // namespace clearcut::voronoi
