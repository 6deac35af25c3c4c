// Finds items near a point: numbers sorted into square cells.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geometry/box.h"

namespace clearcut::inline geometry {

/// Numbers sorted into numbered cells, all at once: lists without gaps between them.
class CellLists {
 public:
  void add(std::size_t cell, std::uint32_t number) {
    added_.emplace_back(static_cast<std::uint32_t>(cell), number);
  }

  /// Sorts in the numbers added since the last call; within a cell, numbers keep their order of arrival.
  void build(std::size_t cells) {
    first_.assign(cells + 1, 0);
    for (const auto& [cell, number] : added_) ++first_[cell + 1];
    for (std::size_t i = 0; i < cells; ++i) first_[i + 1] += first_[i];
    numbers_.resize(added_.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const auto& [cell, number] : added_) numbers_[next[cell]++] = number;
    added_.clear();
  }

  std::span<const std::uint32_t> at(std::size_t cell) const { return in(cell, cell + 1); }
  /// The numbers of the cells from `from` to before `end`, cell by cell.
  std::span<const std::uint32_t> in(std::size_t from, std::size_t end) const {
    return {numbers_.data() + first_[from], numbers_.data() + first_[end]};
  }

 private:
  std::vector<std::pair<std::uint32_t, std::uint32_t>> added_;
  std::vector<std::uint32_t> first_, numbers_;
};

/// Square cells over a box.
struct CellGrid {
  Box box;
  double cell = 1;
  std::size_t columns = 1;
  std::size_t rows = 1;

  CellGrid() = default;
  CellGrid(const Box& of, double size)
      : box(of),
        cell(size),
        columns(static_cast<std::size_t>(of.width() / size) + 1),
        rows(static_cast<std::size_t>(of.height() / size) + 1) {}

  std::size_t count() const { return columns * rows; }
  std::size_t column(double x) const { return index((x - box.min.x) / cell, columns); }
  std::size_t row(double y) const { return index((y - box.min.y) / cell, rows); }
  /// Places beside the box belong to the cells at its edge.
  std::size_t cell_of(Vec2 p) const { return row(p.y) * columns + column(p.x); }
  Vec2 center_of(std::size_t c, std::size_t r) const {
    return {box.min.x + (static_cast<double>(c) + 0.5) * cell,
            box.min.y + (static_cast<double>(r) + 0.5) * cell};
  }

  /// Calls f(cell, its centre) for all cells touched by `where`.
  template <typename F>
  void for_cells(const Box& where, F&& f) const {
    const std::size_t c0 = column(where.min.x), c1 = column(where.max.x), r1 = row(where.max.y);
    for (std::size_t r = row(where.min.y); r <= r1; ++r) {
      for (std::size_t c = c0; c <= c1; ++c) f(r * columns + c, center_of(c, r));
    }
  }

 private:
  static std::size_t index(double v, std::size_t n) {
    return static_cast<std::size_t>(std::clamp(v, 0.0, static_cast<double>(n - 1)));
  }
};

/// Numbers by their boxes or points. Only cells with items exist; cost of a look-up: cells of its box.
class BoxIndex {
 public:
  explicit BoxIndex(double cell) : cell_(cell) {}

  void add(const Box& box, std::uint32_t number) {
    for_cells(box, [&](const Cell& cell) { cells_[cell].push_back(number); });
  }
  void add(Vec2 p, std::uint32_t number) { add(Box{p, p}, number); }

  /// All numbers in the cells touched by `box`, ascending, each once; some of their boxes are up to a cell away from
  /// `box`.
  std::vector<std::uint32_t> near(const Box& box) const {
    std::vector<std::uint32_t> found;
    for_cells(box, [&](const Cell& cell) {
      if (const auto at = cells_.find(cell); at != cells_.end())
        found.insert(found.end(), at->second.begin(), at->second.end());
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }
  /// All numbers within a cell's side of p, and some farther away.
  std::vector<std::uint32_t> near(Vec2 p) const { return near(Box{p, p}.grown(cell_)); }

  /// The numbers whose boxes touch the cell of p, in their order of arrival.
  std::span<const std::uint32_t> at(Vec2 p) const {
    const auto found = cells_.find({index(p.x), index(p.y)});
    if (found == cells_.end()) return {};
    return found->second;
  }

  /// The numbers of the fullest cell; of several equally full cells, of the cell with the least first number.
  std::span<const std::uint32_t> fullest() const {
    std::span<const std::uint32_t> most;
    for (const auto& [cell, numbers] : cells_) {
      if (numbers.size() > most.size() || (numbers.size() == most.size() && numbers.front() < most.front()))
        most = numbers;
    }
    return most;
  }

 private:
  struct Cell {
    std::int64_t column = 0;
    std::int64_t row = 0;
    friend bool operator==(const Cell&, const Cell&) = default;
  };
  /// Multiplies by odd numbers without pattern (the golden ratio's and a prime) and takes the mixed upper half.
  struct CellHash {
    std::size_t operator()(const Cell& cell) const {
      const std::uint64_t mixed = static_cast<std::uint64_t>(cell.column) * 0x9E3779B97F4A7C15ULL +
                                  static_cast<std::uint64_t>(cell.row) * 0xC2B2AE3D27D4EB4FULL;
      return mixed ^ (mixed >> 32U);
    }
  };

  std::int64_t index(double v) const { return static_cast<std::int64_t>(std::floor(v / cell_)); }
  template <typename F>
  void for_cells(const Box& box, F&& f) const {
    const std::int64_t last_column = index(box.max.x), last_row = index(box.max.y);
    for (std::int64_t row = index(box.min.y); row <= last_row; ++row) {
      for (std::int64_t column = index(box.min.x); column <= last_column; ++column) f(Cell{column, row});
    }
  }

  double cell_;
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells_;
};

}  // namespace clearcut::inline geometry
