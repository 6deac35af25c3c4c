// Square lattices: the generator, the recognition of lattices in any point set, and the sweeps covering them.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "order/problem.h"

namespace clearcut::order {

/// columns x rows points with the given pitch in mm, row by row from (0, 0); real distances.
Problem lattice_problem(int columns, int rows, double pitch = 1.0);

/// "10x10" or "100x75": columns and rows, each 1 to 10000; absent when the text has another form.
struct LatticeSize {
  int columns = 0;
  int rows = 0;
};
std::optional<LatticeSize> parse_lattice(std::string_view text);
/// Whether the text is meant as a lattice, even one without points or one that is too large: "0x10", "3x".
bool is_like_lattice(std::string_view text);

/// A point set with points on the crossings of an axis-parallel square lattice, each crossing at most
/// once.
class Lattice {
 public:
  /// Absent unless every coordinate is a whole number of pitches from the lowest, within 1e-6 of a pitch.
  /// The pitch is the smallest difference of coordinates. O(n log n).
  static std::optional<Lattice> recognise(const std::vector<Vec2>& points);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double pitch() const { return pitch_; }
  int size() const { return static_cast<int>(column_.size()); }
  bool full() const { return static_cast<long long>(columns_) * rows_ == size(); }
  int column_of(int v) const { return column_[static_cast<std::size_t>(v)]; }
  int row_of(int v) const { return row_[static_cast<std::size_t>(v)]; }
  /// Point at a crossing, -1 for a hole or outside.
  int at(int column, int row) const {
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return -1;
    return point_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }

 private:
  int columns_ = 0;
  int rows_ = 0;
  double pitch_ = 1;
  std::vector<int> column_, row_;  // column and row by point
  std::vector<int> point_;         // point by crossing
};

/// Orders worth starting from: back-and-forth sweeps along rows and columns from every corner, spirals inward
/// in both senses, and, for closed tours, combs. On lattices with holes sweeps proceed run by run. Ends and
/// precedence are ignored. Each is a permutation; at most 24.
std::vector<Tour> sweeps(const Lattice& lattice, bool closed);

}  // namespace clearcut::order
