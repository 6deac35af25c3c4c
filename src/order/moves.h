// The moves between points with the properties used by objectives: length, directions at both ends, turns. Shapes
// that are costly to find are kept by pair of points in bounded memory.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/vec2.h"
#include "order/problem.h"

namespace clearcut::order {

/// All properties of the move a -> b used by objectives.
struct MoveShape {
  double length = 0;       ///< in the problem's metric
  Vec2 leaves;             ///< direction at a, not normalised
  Vec2 arrives;            ///< direction at b
  int inner_turns = 0;     ///< turns of a legal detour between its ends
  double inner_angle = 0;  ///< degrees
  bool straight = true;
};

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

/// A change of direction below this many degrees is no turn (the same figure as in the findings).
inline constexpr double kTurnThresholdDegrees = 0.1;

/// |angle| between two directions in degrees, 0..180; 0 when either is zero (coincident points).
/// Tour eq. 4.16-4.19: the minor arc between two subpaths, here by one atan2 of cross and dot product.
double turn_angle(Vec2 in, Vec2 out);

/// Whether the angle between the directions is above the threshold; without trigonometry.
bool is_turn(Vec2 in, Vec2 out);

/// Computes straight moves from coordinates, and stores legal detours. Safe for several threads.
class Moves {
 public:
  /// Stores detours in at most this many places; overwritten ones are found anew when needed.
  explicit Moves(const Problem& problem, std::size_t most_places = ShapeStore::kMostPlaces);

  const Problem& problem() const { return *problem_; }
  bool has_detours() const { return static_cast<bool>(problem_->detour); }
  double length(int a, int b) const;
  bool is_straight(int a, int b) const { return !has_detours() || shape(a, b).straight; }
  MoveShape shape(int a, int b) const;
  /// Turns of the move's detour between its ends, and their sum in degrees.
  int inner_turns(int a, int b) const;
  double inner_angle(int a, int b) const;
  /// Directions of travel before and after b on the path a -> b -> c, not normalised.
  std::pair<Vec2, Vec2> directions(int a, int b, int c) const;
  /// Turn at b on the path a -> b -> c, degrees.
  double angle_at(int a, int b, int c) const;
  bool turns_at(int a, int b, int c) const;

 private:
  /// Pairs known to be joined straight need no look into the store of detours.
  enum class Known : signed char { kNot, kStraight, kDetour };
  static constexpr int kMostMarked = 5000;  // points; above, pairs are not marked

  bool known_straight(int low, int high) const {
    return marks_ && marks_[mark_of(low, high)].load(std::memory_order_relaxed) == Known::kStraight;
  }
  bool surely_straight(int a, int b) const {
    return !has_detours() || known_straight(std::min(a, b), std::max(a, b));
  }
  std::size_t mark_of(int low, int high) const {
    return static_cast<std::size_t>(low) * problem_->points.size() + static_cast<std::size_t>(high);
  }
  MoveShape stored_shape(int low, int high) const;
  MoveShape straight_shape(int a, int b) const;
  MoveShape detour_shape(int a, int b) const;

  const Problem* problem_;
  std::unique_ptr<std::atomic<Known>[]> marks_;
  std::unique_ptr<ShapeStore> detours_;
};

}  // namespace clearcut::order
