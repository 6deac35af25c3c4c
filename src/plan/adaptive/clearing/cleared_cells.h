// Tells quickly that nothing stands in places that have long been cleared, without asking for the single
// cuts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/box.h"
#include "geometry/edge.h"

namespace clearcut::plan::adaptive {

/// A grid of square cells; a cell is marked once a single cut has cleared all of it.
///
/// What it reports as cleared is cleared. It does not know about cells at rims of cuts and cells that only
/// several cuts together have cleared. Cuts are marked at the first query after them, so that cuts which are
/// taken back before cost nothing.
class ClearedCells {
 public:
  /// Cells of about `cell` mm inside `where`, larger if there would be too many. Outside it reports nothing
  /// as cleared.
  ClearedCells(const Box& where, double cell);

  /// Adds what a disc of `radius` mm clears along `path`; a point if from == to. Arcs turn by less than a
  /// full turn.
  void add(const Edge& path, double radius);
  /// How many cuts were added.
  std::size_t cuts() const { return cuts_.size(); }
  /// Takes back all but the first `cuts`. Costs O(all of them) if a query came after the cuts taken back.
  void forget_beyond(std::size_t cuts);

  /// Whether the whole disc is known to be cleared. Cost O(radius / cell) or less.
  bool holds(Vec2 center, double radius) const;

 private:
  struct Cut {
    Edge path;
    double radius = 0;
  };
  /// An interval of a row of cells, mm; from < to.
  struct Span {
    double from = 0;
    double to = 0;
  };
  /// A half plane, n * p <= q, that bounds what a line or an arc clears.
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
  /// Calls f for each row of cells that lies between two heights.
  template <typename F>
  void for_rows(double low, double high, F&& f) const;
  static void clip(Span& span, const Border& border, double low, double high);
  bool all_marked(std::size_t row, long first, long last) const;

  Vec2 origin_;
  double cell_;
  long columns_ = 0, rows_ = 0;
  std::size_t words_ = 0;  ///< 64-bit words in a row
  std::vector<Cut> cuts_;
  mutable std::size_t marked_ = 0;  ///< number of cuts that are marked
  mutable std::vector<std::uint64_t> cells_;
};

}  // namespace clearcut::plan::adaptive
