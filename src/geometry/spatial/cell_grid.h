// Finds what lies near a place: numbers sorted into square cells.
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

  /// Sorts in what was added since the last time; within a cell, numbers keep the order in which they came.
  void build(std::size_t cells) {
    first_.assign(cells + 1, 0);
    for (const auto& [cell, number] : added_) ++first_[cell + 1];
    for (std::size_t i = 0; i < cells; ++i) first_[i + 1] += first_[i];
    numbers_.resize(added_.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const auto& [cell, number] : added_) numbers_[next[cell]++] = number;
    added_.clear();
  }

  std::span<const std::uint32_t> at(std::size_t cell) const {
    return {numbers_.data() + first_[cell], numbers_.data() + first_[cell + 1]};
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

  /// Calls f(cell, its centre) for all cells that `where` touches.
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

/// Numbers by the box they lie in. Cells exist only where something lies; cost of a look-up: cells of its
/// box.
class BoxIndex {
 public:
  explicit BoxIndex(double cell) : cell_(cell) {}

  void add(const Box& box, std::uint32_t number) {
    for_cells(box, [&](std::uint64_t key) { cells_[key].push_back(number); });
  }

  /// All numbers whose cells `box` touches, ascending, each once; some of them lie a cell away.
  std::vector<std::uint32_t> near(const Box& box) const {
    std::vector<std::uint32_t> found;
    for_cells(box, [&](std::uint64_t key) {
      if (const auto at = cells_.find(key); at != cells_.end()) {
        found.insert(found.end(), at->second.begin(), at->second.end());
      }
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  template <typename F>
  void for_cells(const Box& box, F&& f) const {
    const auto index = [&](double v) { return static_cast<std::int32_t>(std::floor(v / cell_)); };
    for (std::int32_t r = index(box.min.y); r <= index(box.max.y); ++r) {
      for (std::int32_t c = index(box.min.x); c <= index(box.max.x); ++c) {
        f(static_cast<std::uint64_t>(static_cast<std::uint32_t>(r)) << 32 | static_cast<std::uint32_t>(c));
      }
    }
  }

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace clearcut::inline geometry
