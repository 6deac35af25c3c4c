#include "order/moves.h"

#include <cmath>
#include <utility>

#include "base/elementary.h"
#include "base/units.h"

namespace clearcut::order {

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
