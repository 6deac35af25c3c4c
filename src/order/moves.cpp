#include "order/moves.h"

#include <cmath>
#include <utility>

#include "base/units.h"

namespace clearcut::order {

double turn_angle(Vec2 in, Vec2 out) {
  // atan2 tells 0 from -0, and would answer a half turn for some coincident points.
  if (in == Vec2{} || out == Vec2{}) return 0;
  return std::abs(std::atan2(cross(in, out), dot(in, out))) * (180.0 / kPi);
}

bool is_turn(Vec2 in, Vec2 out) {
  static const double kSlope = std::tan(kTurnThresholdDegrees * kPi / 180.0);
  const double d = dot(in, out);
  const double c = std::abs(cross(in, out));
  return d > 0 ? c > kSlope * d : c > 0 || d < 0;
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

MoveShape Moves::shape(int a, int b) const {
  if (!has_detours()) return straight_shape(a, b);
  const auto [low, high] = std::minmax(a, b);
  const auto key = (static_cast<unsigned long long>(low) << 32) | static_cast<unsigned>(high);
  Shard& shard = (*shards_)[static_cast<std::size_t>(low * 31 + high) % kShards];
  MoveShape shape;
  bool known = false;
  {
    const std::lock_guard lock(shard.mutex);
    const auto it = shard.known.find(key);
    if (it != shard.known.end()) {
      shape = it->second;
      known = true;
    }
  }
  if (!known) {
    shape = detour_shape(low, high);
    const std::lock_guard lock(shard.mutex);
    shard.known.emplace(key, shape);
  }
  if (a != low) {
    shape = MoveShape{shape.length,      -shape.arrives,    -shape.leaves,
                      shape.inner_turns, shape.inner_angle, shape.straight};
  }
  return shape;
}

bool Moves::turns_at(int a, int b, int c) const {
  Vec2 in = problem_->points[b] - problem_->points[a], out = problem_->points[c] - problem_->points[b];
  if (has_detours()) {
    in = shape(a, b).arrives;
    out = shape(b, c).leaves;
  }
  return is_turn(in, out);
}

double Moves::angle_at(int a, int b, int c) const {
  if (!has_detours()) {
    return turn_angle(problem_->points[b] - problem_->points[a], problem_->points[c] - problem_->points[b]);
  }
  return turn_angle(shape(a, b).arrives, shape(b, c).leaves);
}

}  // namespace clearcut::order
