#include "order/shape_store.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace clearcut::order {

namespace {

std::uint64_t pair_of(int low, int high) {
  return (static_cast<std::uint64_t>(low) << 32) | static_cast<std::uint32_t>(high);
}

/// Spreads the pair over all bits, by the golden ratio.
std::uint64_t spread(std::uint64_t pair) {
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ULL;
  pair = (pair ^ (pair >> 32)) * kGolden;
  return (pair ^ (pair >> 29)) * kGolden;
}

/// The lowest bits choose the table, the highest bits the place in the table.
constexpr int kPlaceShift = 32;

}  // namespace

ShapeStore::ShapeStore(std::size_t most_places)
    : most_in_table_(std::max(kFirst, std::bit_ceil(most_places) / kTables)) {}

std::size_t ShapeStore::places() const {
  std::size_t sum = 0;
  for (const Table& table : tables_) {
    const std::lock_guard lock(table.mutex);
    sum += table.places.size();
  }
  return sum;
}

/// Place of the pair, or the free place for it. There is always one.
std::size_t ShapeStore::index_in(const Table& table, std::uint64_t pair) {
  const std::size_t mask = table.places.size() - 1;
  std::size_t i = (spread(pair) >> kPlaceShift) & mask;
  while (table.places[i].pair != pair && table.places[i].pair != kNone) i = (i + 1) & mask;
  return i;
}

std::optional<MoveShape> ShapeStore::find(int low, int high) const {
  const std::uint64_t pair = pair_of(low, high);
  const Table& table = tables_[spread(pair) % kTables];
  const std::lock_guard lock(table.mutex);
  if (table.places.empty()) return std::nullopt;
  const Place& place = table.places[index_in(table, pair)];
  if (place.pair == kNone) return std::nullopt;
  return place.shape;
}

/// Three quarters of the places at most are taken, so that searches stay short.
void ShapeStore::make_room(Table& table) const {
  if (4 * (table.taken + 1) <= 3 * table.places.size()) return;
  const bool is_full = table.places.size() == most_in_table_;
  std::vector<Place> before(is_full ? most_in_table_ : std::max(kFirst, 2 * table.places.size()));
  before.swap(table.places);
  if (is_full) {
    table.taken = 0;
    return;
  }
  for (const Place& place : before)
    if (place.pair != kNone) table.places[index_in(table, place.pair)] = place;
}

void ShapeStore::keep(int low, int high, const MoveShape& shape) {
  const std::uint64_t pair = pair_of(low, high);
  Table& table = tables_[spread(pair) % kTables];
  const std::lock_guard lock(table.mutex);
  make_room(table);
  Place& place = table.places[index_in(table, pair)];
  table.taken += place.pair == kNone ? 1 : 0;
  place = {pair, shape};
}

}  // namespace clearcut::order
