#include "order/moves.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "base/elementary.h"
#include "base/units.h"

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

double turn_angle(Vec2 in, Vec2 out) {
  // atan2 distinguishes 0 from -0, and would return a half turn for some coincident points.
  if (in == Vec2{} || out == Vec2{}) return 0;
  return std::abs(base::atan2(cross(in, out), dot(in, out))) * (180.0 / kPi);
}

bool is_turn(Vec2 in, Vec2 out) {
  static const double kSlope = base::tan(kTurnThresholdDegrees * kPi / 180.0);
  const double d = dot(in, out);
  const double c = std::abs(cross(in, out));
  return d > 0 ? c > kSlope * d : c > 0 || d < 0;
}

Moves::Moves(const Problem& problem, std::size_t most_places) : problem_(&problem) {
  const std::size_t n = problem.points.size();
  if (has_detours()) detours_ = std::make_unique<ShapeStore>(most_places);
  if (has_detours() && problem.size() <= kMostMarked) marks_ = std::make_unique<std::atomic<Known>[]>(n * n);
}

MoveShape Moves::straight_shape(int a, int b) const {
  MoveShape shape;
  shape.length = straight_distance(*problem_, a, b);
  shape.leaves = shape.arrives = problem_->points[b] - problem_->points[a];
  return shape;
}

MoveShape Moves::detour_shape(int a, int b) const {
  const std::vector<Vec2> points = move_points(*problem_, a, b);
  if (points.size() == 2) return straight_shape(a, b);
  MoveShape shape;
  shape.straight = false;
  shape.length = way_length(*problem_, points);
  shape.leaves = points[1] - points[0];
  shape.arrives = points[points.size() - 1] - points[points.size() - 2];
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double angle = turn_angle(points[i] - points[i - 1], points[i + 1] - points[i]);
    shape.inner_angle += angle;
    shape.inner_turns += is_turn(points[i] - points[i - 1], points[i + 1] - points[i]) ? 1 : 0;
  }
  return shape;
}

MoveShape Moves::stored_shape(int low, int high) const {
  if (const auto known = detours_->find(low, high)) return *known;
  const MoveShape shape = detour_shape(low, high);
  if (marks_) marks_[mark_of(low, high)].store(shape.straight ? Known::kStraight : Known::kDetour);
  if (!shape.straight || !marks_) detours_->keep(low, high, shape);
  return shape;
}

MoveShape Moves::shape(int a, int b) const {
  if (surely_straight(a, b)) return straight_shape(a, b);
  const MoveShape shape = stored_shape(std::min(a, b), std::max(a, b));
  if (a <= b) return shape;
  return {shape.length, -shape.arrives, -shape.leaves, shape.inner_turns, shape.inner_angle, shape.straight};
}

int Moves::inner_turns(int a, int b) const {
  return surely_straight(a, b) ? 0 : stored_shape(std::min(a, b), std::max(a, b)).inner_turns;
}

double Moves::inner_angle(int a, int b) const {
  return surely_straight(a, b) ? 0 : stored_shape(std::min(a, b), std::max(a, b)).inner_angle;
}

double Moves::length(int a, int b) const {
  if (surely_straight(a, b)) return straight_distance(*problem_, a, b);
  return stored_shape(std::min(a, b), std::max(a, b)).length;
}

std::pair<Vec2, Vec2> Moves::directions(int a, int b, int c) const {
  const auto& points = problem_->points;
  return {surely_straight(a, b) ? points[b] - points[a] : shape(a, b).arrives,
          surely_straight(b, c) ? points[c] - points[b] : shape(b, c).leaves};
}

bool Moves::turns_at(int a, int b, int c) const {
  const auto [in, out] = directions(a, b, c);
  return is_turn(in, out);
}

double Moves::angle_at(int a, int b, int c) const {
  const auto [in, out] = directions(a, b, c);
  return turn_angle(in, out);
}

}  // namespace clearcut::order
