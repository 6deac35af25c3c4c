// Where nothing stands any more, told without a look at the cuts: what has long been cleared costs next to nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/box.h"
#include "geometry/edge.h"

namespace clearcut::plan::adaptive {

/// Square cells that single cuts have cleared wholly.
///
/// What it says is cleared is cleared; near the rims of cuts, and where only several cuts together clear a cell, it
/// does not know. Cuts are marked when something is asked, so trials that are taken back before cost nothing.
class ClearedCells {
 public:
  /// Of about `cell` mm inside `where`; larger ones where that would be too many. Outside nothing is known.
  ClearedCells(const Box& where, double cell);

  /// Notes what a disc of `radius` mm clears along `path` (a point where from == to). Arcs turn by less than a full turn.
  void add(const Edge& path, double radius);
  /// How many were added, and the way back to fewer: O(all of them) if something was asked since.
  std::size_t cuts() const { return cuts_.size(); }
  void forget_beyond(std::size_t cuts);

  /// Whether the whole disc is known to be cleared. Cost O(radius / cell), or less where it is not.
  bool holds(Vec2 center, double radius) const;

 private:
  struct Cut {
    Edge path;
    double radius = 0;
  };
  /// From < to, mm, in a row.
  struct Span {
    double from = 0;
    double to = 0;
  };
  /// The directions before which a straight border lies: n * p <= q.
  struct Border {
    Vec2 normal;
    double q = 0;
  };
  void mark_new() const;
  void mark(const Cut& cut) const;
  void mark_disc(Vec2 center, double radius) const;
  void mark_line(const Edge& line, double radius) const;
  void mark_arc(const Edge& arc, double radius) const;
  void mark_span(long row, Span span) const;
  /// Rows wholly between two heights.
  template <typename F>
  void for_rows(double low, double high, F&& f) const;
  static void clip(Span& span, const Border& border, double low, double high);
  bool all_marked(std::size_t row, long first, long last) const;

  Vec2 origin_;
  double cell_;
  long columns_ = 0, rows_ = 0;
  std::size_t words_ = 0;  ///< of a row
  std::vector<Cut> cuts_;
  mutable std::size_t marked_ = 0;  ///< cuts that are marked already
  mutable std::vector<std::uint64_t> cells_;
};

}  // namespace clearcut::plan::adaptive
