// The moves between points with the properties used by objectives: length, directions at both ends, turns.
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>

#include "order/move_shape.h"
#include "order/problem.h"
#include "order/shape_store.h"

namespace clearcut::order {

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
