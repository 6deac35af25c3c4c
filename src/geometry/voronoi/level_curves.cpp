// Cuts every Voronoi edge at the levels, joins the cuts inside each cell. After the counts of levels at the
// nodes everything is integer logic: both cells of an edge see the same counts, so every curve closes.
#include "geometry/voronoi/level_curves.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "geometry/voronoi/index.h"

namespace clearcut::inline geometry::voronoi {
namespace {

class Tracer {
 public:
  Tracer(const Diagram& diagram, const std::vector<double>& levels, double margin)
      : diagram_(diagram), levels_(levels), margin_(margin) {}

  std::vector<LevelCurve> run() {
    count_levels();
    number_cuts();
    for (std::size_t cell = 0; cell < diagram_.cell_start.size(); ++cell) {
      if (is_cut_[cell] != 0 && diagram_.cell_start[cell] >= 0) join_in_cell(static_cast<int>(cell));
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

  int depth(int node) const { return node < 0 ? 0 : depth_[index(node)]; }

  void count_levels() {
    depth_.resize(diagram_.nodes.size());
    for (std::size_t i = 0; i < depth_.size(); ++i) {
      const auto deeper =
          std::upper_bound(levels_.begin(), levels_.end(), diagram_.nodes[i].clearance - margin_);
      depth_[i] = diagram_.inside[i] != 0 ? static_cast<int>(deeper - levels_.begin()) : 0;
    }
  }

  void number_cuts() {
    first_cut_.resize(index(diagram_.edge_count()));
    is_cut_.assign(diagram_.cell_start.size(), 0);
    for (int k = 0; k < diagram_.edge_count(); ++k) {
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
      is_cut_[index(diagram_.cell[index(2 * k)])] = is_cut_[index(diagram_.cell[index(2 * k + 1)])] = 1;
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
  const std::vector<double>& levels_;
  double margin_;
  std::vector<int> depth_, first_cut_, open_, unmatched_;
  std::vector<char> is_cut_;  ///< per cell: whether a level crosses one of its edges
  std::vector<Cut> cuts_;
};

}  // namespace

std::vector<LevelCurve> level_curves(const Diagram& diagram, const std::vector<double>& levels,
                                     double margin) {
  return Tracer(diagram, levels, margin).run();
}

}  // namespace clearcut::inline geometry::voronoi
