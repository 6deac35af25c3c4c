#include "geometry/voronoi/offset_loop.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/tolerances.h"
#include "base/units.h"

namespace clearcut::inline geometry::voronoi {
namespace {

/// mm. Below this a turn of the boundary leaves no arc worth writing: the two offset curves meet in one
/// point.
constexpr double kLeastArc = 2e-4;
/// mm. Joints nearer than this are one.
constexpr double kOneJoint = 1e-7;

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double length_squared = norm_squared(d);
  const double t = length_squared > 0 ? std::clamp(dot(p - a, d) / length_squared, 0.0, 1.0) : 0.0;
  return norm(p - (a + d * t));
}

/// The arc with its centre moved parallel to the chord until both ends are equally far; a line if no arc is left.
Edge centred(Edge arc) {
  const Vec2 chord = arc.to - arc.from;
  const double excess = norm_squared(arc.from - arc.center) - norm_squared(arc.to - arc.center);
  const Vec2 shift = chord * (-excess / (2 * norm_squared(chord)));
  if (norm_squared(shift) > norm_squared(chord) && norm_squared(shift) > 1e-12)
    return Edge::line(arc.from, arc.to);
  arc.center = arc.center + shift;
  return arc;
}

Edge exact_edge(const OffsetCurve& curve, Vec2 from, Vec2 to) {
  if (curve.straight) return Edge::line(from, to);
  const Edge arc = Edge::arc(from, to, curve.point, curve.turn);
  const double off_from = std::abs(norm(from - curve.point) - curve.radius);
  const double off_to = std::abs(norm(to - curve.point) - curve.radius);
  return off_from <= kRoundingMm && off_to <= kRoundingMm ? arc : centred(arc);
}

Edge fitted(Edge edge, Vec2 to) {
  edge.to = to;
  return edge.is_arc() ? centred(edge) : edge;
}

/// Moves the end of the last edge by less than kOneJoint.
void close(Loop& loop, Vec2 to) {
  loop.back() = fitted(loop.back(), to);
}

bool are_neighbours(const Element& a, const Element& b) {
  return !a.is_point() && !b.is_point() && a.edge.to == b.edge.from;
}

/// Places `d` mm to the left of the end and of the start of an edge.
Vec2 end_of(const Element& edge, double d) {
  return edge.edge.to + left_of(edge.edge.tangent_at(1)) * d;
}
Vec2 start_of(const Element& edge, double d) {
  return edge.edge.from + left_of(edge.edge.tangent_at(0)) * d;
}

class Assembler {
 public:
  Assembler(const Diagram& diagram, const LevelCurve& curve, double d, double slack)
      : diagram_(diagram), d_(d), slack_(slack), pieces_(curve.pieces) {}

  std::optional<Loop> run() {
    if (pieces_.size() == 1) return full_circle();
    drop_shrunken_arcs();
    drop_false_vertices();
    insert_missing_vertices();
    do {
      if (pieces_.size() < 2) return std::nullopt;
      solve_joints();
    } while (drop_reversed());
    return emit();
  }

 private:
  const Element& element(const Piece& piece) const { return diagram_.element(piece.element); }
  std::size_t count() const { return pieces_.size(); }
  Piece& piece(std::size_t i) { return pieces_[i % count()]; }
  const Piece& piece(std::size_t i) const { return pieces_[i % count()]; }
  /// Elements on both sides of the joint at the start of piece i.
  const Element& before(std::size_t i) const { return element(piece(i + count() - 1)); }
  const Element& after(std::size_t i) const { return element(piece(i)); }

  /// Removes pieces; the piece after a removed run starts in the middle of the run. Neighbouring pieces that are then
  /// of one element become one piece.
  void remove(const std::vector<char>& gone) {
    const auto kept = std::find(gone.begin(), gone.end(), 0);
    if (kept == gone.end()) return pieces_.clear();
    // Once around, beginning at a kept piece: no run of removed pieces is split.
    const auto start = static_cast<std::size_t>(kept - gone.begin());
    std::vector<Piece> left;
    for (std::size_t k = 0; k < count(); ++k) {
      const std::size_t i = (start + k) % count();
      if (gone[i] == 0) left.push_back(gone[(i + count() - 1) % count()] == 0 ? piece(i) : bridged(i, gone));
    }
    pieces_ = std::move(left);
    merge_equal_neighbours();
  }

  Piece bridged(std::size_t i, const std::vector<char>& gone) const {
    std::size_t first = i + count() - 1;
    while (gone[(first + count() - 1) % count()] != 0) first = (first + count() - 1) % count();
    const Vec2 from = piece(first).guess, to = piece(i).guess;
    return {piece(i).element, lerp(from, to, 0.5), from, to, false, true, {}};
  }

  /// Of two equal neighbours the first continues: the start of the second becomes a place inside the joined piece.
  void merge_equal_neighbours() {
    std::vector<Piece> left;
    for (const Piece& p : pieces_) {
      if (left.empty() || left.back().element != p.element) left.push_back(p);
    }
    if (left.size() > 1 && left.front().element == left.back().element) {
      left.front() = left.back();
      left.pop_back();
    }
    pieces_ = std::move(left);
  }

  /// Removes the pieces for which `is_false` is true; returns whether there were any.
  template <class Test>
  bool remove_if(Test is_false) {
    std::vector<char> gone(count(), 0);
    for (std::size_t i = 0; i < count(); ++i) {
      // Never two neighbours at once: without the first, the second may be right.
      const bool beside_gone = gone[(i + count() - 1) % count()] != 0 || gone[(i + 1) % count()] != 0;
      if (!beside_gone && is_false(i)) gone[i] = 1;
    }
    if (std::find(gone.begin(), gone.end(), 1) == gone.end()) return false;
    remove(gone);
    return true;
  }

  /// Whether the neighbouring offset curves, prolonged until they meet without the arc, stay within the slack of the
  /// arc.
  bool is_shrunken(const Element& arc) const {
    const double left = arc.radius - d_, half = std::abs(arc.edge.sweep()) / 2;
    if (left <= kOneJoint) return true;
    return left < slack_ && half < kPi / 2 && left * (1 / base::cos(half) - 1) < slack_ / 2;
  }

  /// Concave arcs whose offset has (almost) shrunk to their centre.
  void drop_shrunken_arcs() {
    while (count() > 0 && remove_if([this](std::size_t i) {
             return after(i).wall == Wall::kConcave && is_shrunken(after(i));
           })) {
    }
  }

  /// Distance between the offsets of two edges at their common vertex, > 0 if an arc about the vertex joins them.
  double opening(const Edge& before, const Edge& after) const {
    const Vec2 a = before.tangent_at(1), b = after.tangent_at(0);
    return -d_ * base::atan2(cross(a, b), dot(a, b));
  }

  /// Point of the offset beside the vertex between edge a and the following edge b.
  Vec2 beside_vertex(const Element& a, const Element& b) const {
    const Vec2 n = left_of(a.edge.tangent_at(1)) + left_of(b.edge.tangent_at(0));
    return a.edge.to + n * (d_ / norm(n));
  }

  /// Whether a joint opens by less than an arc worth writing, or closes, by a small angle: rounding hides no
  /// wide one. (A turn by half a round is the tip of a wall of no thickness.)
  bool is_closed(double wide) const { return wide <= kLeastArc && wide > -d_ * kPi / 2; }

  /// Sites are rounded and may give a vertex the wrong turn: the exact tangents decide here.
  void drop_false_vertices() {
    if (count() < 3) return;
    remove_if([this](std::size_t i) {
      const Element &a = before(i), &v = after(i), &b = after(i + 1);
      if (!v.is_point() || !are_neighbours(a, b) || a.edge.to != v.edge.from) return false;
      return is_closed(opening(a.edge, b.edge));
    });
  }

  void insert_missing_vertices() {
    std::vector<Piece> all;
    all.reserve(count());
    for (std::size_t i = 0; i < count(); ++i) {
      if (lacks_vertex(i)) {
        const Element &a = before(i), &b = after(i);
        const Vec2 start = end_of(a, d_), end = start_of(b, d_);
        all.push_back({a.end_vertex, start, start, start, false, false, {}});
        all.push_back({piece(i).element, end, end, end, false, false, {}});
      } else {
        all.push_back(piece(i));
      }
    }
    pieces_ = std::move(all);
  }

  bool lacks_vertex(std::size_t i) const {
    const Element &a = before(i), &b = after(i);
    if (!are_neighbours(a, b)) return false;
    const double wide = opening(a.edge, b.edge);
    return wide > kLeastArc && wide < d_ * kPi / 2 && starts_beside_vertex(i);
  }

  /// Whether the joint before piece i is beside the common vertex and not at another meeting point of the two edges.
  bool starts_beside_vertex(std::size_t i) const {
    const Element &a = before(i), &b = after(i);
    const double to_vertex = norm(piece(i).guess - beside_vertex(a, b));
    const auto met = meeting_near(offset_curve(a, d_), offset_curve(b, d_), piece(i).guess, slack_);
    return !met || to_vertex <= norm(*met - piece(i).guess) + opening(a.edge, b.edge);
  }

  /// A full circle around one element: an island of a single point, or a nearly closed arc. All other full circles
  /// are accidents of rounding about an arc's centre.
  std::optional<Loop> full_circle() const {
    const Element& only = element(pieces_[0]);
    if (only.edge.is_arc() && std::abs(only.edge.sweep()) < 1.9 * kPi) return std::nullopt;
    const OffsetCurve circle = offset_curve(only, d_);
    if (circle.straight || circle.radius <= kOneJoint) return std::nullopt;
    const Vec2 a = circle.point - Vec2{circle.radius, 0}, b = circle.point + Vec2{circle.radius, 0};
    return Loop{Edge::arc(a, b, circle.point, circle.turn), Edge::arc(b, a, circle.point, circle.turn)};
  }

  void solve_joints() {
    for (std::size_t i = 0; i < count(); ++i) {
      if (!pieces_[i].joint) pieces_[i].joint = solve_joint(i);
    }
  }

  Vec2 solve_joint(std::size_t i) const {
    const Piece& here = piece(i);
    const Element &a = before(i), &b = after(i);
    if (b.is_point() && !a.is_point() && a.edge.to == b.edge.from) return end_of(a, d_);
    if (a.is_point() && !b.is_point() && b.edge.from == a.edge.from) return start_of(b, d_);
    if (are_neighbours(a, b) && std::abs(opening(a.edge, b.edge)) <= kLeastArc && starts_beside_vertex(i)) {
      return beside_vertex(a, b);
    }
    const auto met = meeting_near(offset_curve(a, d_), offset_curve(b, d_), here.guess, slack_);
    return met && distance_to_segment(*met, here.low, here.high) <= reach(here) ? *met : here.guess;
  }

  /// Greatest distance of a joint from the ends of its bisector.
  double reach(const Piece& here) const {
    if (here.at_node) return slack_;
    // Sites within an error of an arc may differ from the arc's direction by up to the square root of that error.
    const double root = here.mended ? 2 * std::sqrt(diagram_.sites.error * d_) : 0;
    return 0.5 * norm(here.high - here.low) + 20 * slack_ + root;
  }

  Vec2 joint(std::size_t i) const { return *piece(i).joint; }

  /// A piece running against its direction exists only in the diagram: its neighbours meet without it.
  bool drop_reversed() {
    return remove_if([this](std::size_t i) { return runs_backwards(i); });
  }

  bool runs_backwards(std::size_t i) const {
    const OffsetCurve curve = offset_curve(after(i), d_);
    if (curve.straight) return dot(joint(i + 1) - joint(i), curve.direction) < -kOneJoint;
    // The offset of an arc turns no farther than the arc, the offset of a vertex no farther than half a circle. An
    // arc running slightly backwards appears as a nearly full circle instead.
    const Edge& source = after(i).edge;
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
      if (norm(to - from) <= kOneJoint) {
        if (last && !loop.empty()) close(loop, to);
        continue;
      }
      loop.push_back(exact_edge(offset_curve(element(piece(i)), d_), from, to));
      from = to;
    }
    if (loop.size() < 2) return std::nullopt;
    return loop;
  }

  const Diagram& diagram_;
  double d_;
  double slack_;
  std::vector<Piece> pieces_;
};

}  // namespace

std::optional<Loop> offset_loop(const Diagram& diagram, const LevelCurve& curve, double d, double slack) {
  return Assembler(diagram, curve, d, slack).run();
}

}  // namespace clearcut::inline geometry::voronoi
