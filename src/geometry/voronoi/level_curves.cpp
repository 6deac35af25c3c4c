// Cuts every Voronoi edge at the levels, joins the cuts inside each cell. After the counts of levels at the
// nodes everything is integer logic: both cells of an edge see the same counts, so every curve closes.
#include "geometry/voronoi/level_curves.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "geometry/voronoi/diagram.h"

namespace clearcut::inline geometry::voronoi {
namespace {

class Tracer {
 public:
  Tracer(const Diagram& diagram, const std::vector<int>& reaching, const std::vector<double>& levels,
         double margin)
      : diagram_(diagram), reaching_(reaching), levels_(levels), margin_(margin) {}

  std::vector<LevelCurve> run() {
    number_cuts();
    for (const int cell : cut_cells_) {
      if (diagram_.cell_start[index(cell)] >= 0) join_in_cell(cell);
    }
    return trace();
  }

 private:
  struct Cut {
    int level = 0;
    int a = -1, b = -1;  ///< nodes at the ends of its stretch, -1 at infinity
    int next = -1;       ///< the rising cut at the end of the piece starting here
    int cell = -1;       ///< cell of that piece
  };

  /// Number of levels that a node belongs to.
  int depth(int node) const {
    if (node < 0 || diagram_.inside[index(node)] == 0) return 0;
    const double clearance = diagram_.nodes[index(node)].clearance - margin_;
    return static_cast<int>(std::upper_bound(levels_.begin(), levels_.end(), clearance) - levels_.begin());
  }

  void number_cuts() {
    first_cut_.resize(index(diagram_.edge_count()));
    is_cut_.assign(diagram_.cell_start.size(), 0);
    for (const int k : reaching_) {
      first_cut_[index(k)] = static_cast<int>(cuts_.size());
      const int v = diagram_.origin[index(2 * k)], w = diagram_.origin[index(2 * k + 1)];
      const int middle = diagram_.critical[index(k)];
      if (middle < 0) {
        add_cuts(v, w);
      } else {
        add_cuts(v, middle);
        add_cuts(middle, w);
      }
      if (static_cast<int>(cuts_.size()) == first_cut_[index(k)]) continue;
      for (const int cell : {diagram_.cell[index(2 * k)], diagram_.cell[index(2 * k + 1)]}) {
        if (is_cut_[index(cell)] == 0) cut_cells_.push_back(cell);
        is_cut_[index(cell)] = 1;
      }
    }
  }

  /// Cuts of a stretch, ascending by level.
  void add_cuts(int a, int b) {
    const int low = std::min(depth(a), depth(b)), high = std::max(depth(a), depth(b));
    for (int level = low; level < high; ++level) cuts_.push_back({level, a, b, -1, -1});
  }

  void join_in_cell(int cell) {
    open_.clear();
    unmatched_.clear();
    const int start = diagram_.cell_start[index(cell)];
    int h = start;
    do {
      walk_edge(h, cell);
      h = diagram_.next[index(h)];
    } while (h != start);
    // Falling cuts met before any rising one close the pieces still open, deepest first.
    CLEARCUT_ASSERT(open_.size() == unmatched_.size());
    for (const int falling : unmatched_) link_to_open(falling, cell);
  }

  void walk_edge(int h, int cell) {
    const int k = h / 2, v = diagram_.origin[index(2 * k)], w = diagram_.origin[index(2 * k + 1)];
    const int middle = diagram_.critical[index(k)], first = first_cut_[index(k)];
    const bool forward = h % 2 == 0;
    if (middle < 0) {
      walk_stretch(forward ? depth(v) : depth(w), forward ? depth(w) : depth(v), first, cell);
      return;
    }
    const int second = first + std::abs(depth(v) - depth(middle));
    if (forward) {
      walk_stretch(depth(v), depth(middle), first, cell);
      walk_stretch(depth(middle), depth(w), second, cell);
    } else {
      walk_stretch(depth(w), depth(middle), second, cell);
      walk_stretch(depth(middle), depth(v), first, cell);
    }
  }

  void walk_stretch(int from, int to, int first, int cell) {
    for (int level = from; level < to; ++level) open_.push_back(first + level - from);
    for (int level = from - 1; level >= to; --level) {
      const int falling = first + level - to;
      if (open_.empty()) {
        unmatched_.push_back(falling);
      } else {
        link_to_open(falling, cell);
      }
    }
  }

  void link_to_open(int falling, int cell) {
    cuts_[index(falling)].next = open_.back();
    cuts_[index(falling)].cell = cell;
    open_.pop_back();
  }

  std::vector<LevelCurve> trace() {
    std::vector<LevelCurve> curves;
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      if (cuts_[i].cell < 0) continue;
      curves.push_back({cuts_[i].level, {}});
      int cut = static_cast<int>(i);
      do {
        Cut& here = cuts_[index(cut)];
        add_piece(here, curves.back().pieces);
        here.cell = -1;
        cut = here.next;
      } while (cut != static_cast<int>(i));
      join_ends(curves.back().pieces);
    }
    std::stable_sort(curves.begin(), curves.end(),
                     [](const LevelCurve& a, const LevelCurve& b) { return a.level < b.level; });
    return curves;
  }

  void add_piece(const Cut& cut, std::vector<Piece>& pieces) const {
    const Piece piece = piece_at(cut);
    if (pieces.empty() || pieces.back().element != piece.element) pieces.push_back(piece);
  }

  static void join_ends(std::vector<Piece>& pieces) {
    if (pieces.size() < 2 || pieces.front().element != pieces.back().element) return;
    // The last piece continues as the first: the first takes over the start of the last.
    pieces.front() = pieces.back();
    pieces.pop_back();
  }

  Piece piece_at(const Cut& cut) const {
    // An edge to infinity ends beyond the region; only its part between the other node and the wall matters.
    const int a = cut.a >= 0 ? cut.a : cut.b, b = cut.b >= 0 ? cut.b : cut.a;
    const Node &p = diagram_.nodes[index(a)], &q = diagram_.nodes[index(b)];
    const double rise = q.clearance - p.clearance, d = levels_[index(cut.level)];
    const double t = rise != 0 ? (d - p.clearance) / rise : 0.0;
    const bool beyond = t < 0 || t > 1;
    const Vec2 guess = lerp(p.point, q.point, std::clamp(t, 0.0, 1.0));
    const int element = diagram_.element_near(cut.cell, guess);
    if (beyond) return {element, guess, guess, guess, true, false, {}};
    return {element, guess, p.point, q.point, false, false, {}};
  }

  const Diagram& diagram_;
  const std::vector<int>& reaching_;
  const std::vector<double>& levels_;
  double margin_;
  std::vector<int> first_cut_, open_, unmatched_, cut_cells_;
  std::vector<char> is_cut_;  ///< per cell: whether a level crosses one of its edges
  std::vector<Cut> cuts_;
};

}  // namespace

std::vector<int> edges_reaching(const Diagram& diagram, double level, double margin) {
  const auto reaches = [&](int node) {
    return node >= 0 && diagram.inside[index(node)] != 0 &&
           level <= diagram.nodes[index(node)].clearance - margin;
  };
  std::vector<int> edges;
  for (int k = 0; k < diagram.edge_count(); ++k) {
    if (reaches(diagram.origin[index(2 * k)]) || reaches(diagram.origin[index(2 * k + 1)]) ||
        reaches(diagram.critical[index(k)]))
      edges.push_back(k);
  }
  return edges;
}

std::vector<LevelCurve> level_curves(const Diagram& diagram, const std::vector<int>& reaching,
                                     const std::vector<double>& levels, double margin) {
  return Tracer(diagram, reaching, levels, margin).run();
}

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
