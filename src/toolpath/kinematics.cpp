#include "toolpath/kinematics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace clearcut {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

struct Direction {
  double x = 0, y = 0, z = 0;
};

double dot(const Direction& a, const Direction& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Unit direction of travel at parameter t of a move of positive length.
Direction direction_at(const Move& move, double t) {
  const double dz = move.z_to - move.z_from;
  if (move.is_vertical()) return {0, 0, dz > 0 ? 1.0 : -1.0};
  const double plan = move.path.length(), space = std::hypot(plan, dz);
  const Vec2 u = move.path.tangent_at(t) * (plan / space);
  return {u.x, u.y, dz / space};
}

/// mm/s: the programmed speed, or what the machine or the arc's curvature allows.
double nominal_speed(const Move& move, const Machine& machine) {
  const double programmed = move.feed.mm_per_s();
  double speed = is_rapid(move.kind) || programmed <= 0 ? machine.rapid.mm_per_s() : programmed;
  if (!is_rapid(move.kind) && machine.max_feed) speed = std::min(speed, machine.max_feed->mm_per_s());
  if (!move.path.is_arc()) return speed;
  // The radius of curvature of a helix is r / cos^2 of its climb.
  const double plan = move.path.length(), climb = (move.z_to - move.z_from) / plan;
  return std::min(speed, std::sqrt(machine.acceleration * move.path.radius() * (1 + climb * climb)));
}

/// Square of the greatest speed through the corner between two moves (Grbl, planner.c: junction deviation).
double junction_speed_squared(const Move& before, const Move& after, const Machine& machine) {
  const double straightness = std::clamp(dot(direction_at(before, 1), direction_at(after, 0)), -1.0, 1.0);
  const double s = std::sqrt((1 + straightness) / 2);  // sin(theta / 2)
  if (s > 1 - 1e-9) return kInfinite;
  return machine.acceleration * machine.junction_deviation * s / (1 - s);
}

/// Time over `length` mm from v0 to v1 with at most `top` in between, all mm/s; reachable by the passes
/// below.
double trapezoid_time(double length, double v0, double v1, double top, double a) {
  const double peak = std::min(top, std::sqrt(std::max(0.0, a * length + (v0 * v0 + v1 * v1) / 2)));
  const double up = (peak * peak - v0 * v0) / (2 * a), down = (peak * peak - v1 * v1) / (2 * a);
  const double cruise = std::max(0.0, length - up - down);
  const double cruise_time = peak > 0 ? cruise / peak : 0;
  return (peak - v0) / a + (peak - v1) / a + cruise_time;
}

}  // namespace

std::vector<Seconds> move_times(std::span<const Move> moves, const Machine& machine) {
  CLEARCUT_ASSERT(machine.acceleration > 0 && machine.rapid.mm_per_min() > 0);
  std::vector<double> length, top;
  std::vector<std::size_t> index;  // moves of no length take no time and do not stop the others
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (moves[i].length() <= 0) continue;
    index.push_back(i);
    length.push_back(moves[i].length());
    top.push_back(nominal_speed(moves[i], machine));
  }
  const double a = machine.acceleration;
  std::vector<double> entry(index.size() + 1, 0.0);  // squares of the speeds between moves
  for (std::size_t k = 1; k < index.size(); ++k) {
    const double corner = junction_speed_squared(moves[index[k - 1]], moves[index[k]], machine);
    entry[k] = std::min({corner, top[k - 1] * top[k - 1], top[k] * top[k]});
  }
  for (std::size_t k = index.size(); k-- > 0;)
    entry[k] = std::min(entry[k], entry[k + 1] + 2 * a * length[k]);
  for (std::size_t k = 0; k < index.size(); ++k)
    entry[k + 1] = std::min(entry[k + 1], entry[k] + 2 * a * length[k]);
  std::vector<Seconds> times(moves.size());
  for (std::size_t k = 0; k < index.size(); ++k) {
    times[index[k]] =
        Seconds::of(trapezoid_time(length[k], std::sqrt(entry[k]), std::sqrt(entry[k + 1]), top[k], a));
  }
  return times;
}

Seconds kinematic_time(std::span<const Move> moves, const Machine& machine) {
  Seconds sum;
  for (const Seconds time : move_times(moves, machine)) sum = sum + time;
  return sum;
}

Seconds naive_time(const Move& move, const Machine& machine) {
  const double programmed = move.feed.mm_per_s();
  const double speed = is_rapid(move.kind) || programmed <= 0 ? machine.rapid.mm_per_s() : programmed;
  return Seconds::of(move.length() / speed);
}

double travel_time(double length, double speed, double acceleration) {
  if (length <= 0) return 0;
  const double full = speed * speed / acceleration;
  return length < full ? 2 * std::sqrt(length / acceleration) : length / speed + speed / acceleration;
}

}  // namespace clearcut
