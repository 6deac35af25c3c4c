// Shapes of moves that are costly to find, kept by pair of points in bounded memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "order/move_shape.h"

namespace clearcut::order {

/// Flat hash tables that grow up to a bound. A full table is cleared, and its entries are computed again when needed,
/// so results never depend on the stored entries. Safe for several threads.
class ShapeStore {
 public:
  /// 75 MB of places, of which at most three quarters are used: all pairs of 1250 points.
  static constexpr std::size_t kMostPlaces = std::size_t{1} << 20;

  /// `most_places` is rounded up to a power of two, at least 8 for each of the tables.
  explicit ShapeStore(std::size_t most_places = kMostPlaces);

  /// Absent if the shape was never stored, or is no longer stored.
  std::optional<MoveShape> find(int low, int high) const;
  void keep(int low, int high, const MoveShape& shape);

  /// Places for shapes, taken or free, now.
  std::size_t places() const;

 private:
  static constexpr std::size_t kTables = 16;  ///< locked each on its own
  static constexpr std::size_t kFirst = 8;    ///< places of a table at the beginning
  static constexpr std::uint64_t kNone = ~std::uint64_t{0};
  struct Place {
    std::uint64_t pair = kNone;
    MoveShape shape;
  };
  struct Table {
    mutable std::mutex mutex;
    std::vector<Place> places;
    std::size_t taken = 0;
  };
  static std::size_t index_in(const Table& table, std::uint64_t pair);
  void make_room(Table& table) const;

  std::size_t most_in_table_;
  std::array<Table, kTables> tables_;
};

}  // namespace clearcut::order
