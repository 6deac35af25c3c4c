#include "kinematics/leg.h"

#include <algorithm>

#include "base/elementary.h"

namespace clearcut::kinematics {
namespace {

/// Unit direction of travel at a point with the tangent `tangent` in plan.
Vec3 in_space(const Leg& leg, Vec2 tangent) {
  const double flat = leg.plan / leg.length;
  return {tangent.x * flat, tangent.y * flat, leg.climb() / leg.length};
}

void set_directions(Leg& leg) {
  const Move& move = *leg.move;
  if (move.is_vertical()) {
    leg.first = leg.last = {0, 0, leg.climb() > 0 ? 1.0 : -1.0};
  } else if (leg.arc) {
    leg.first = in_space(leg, move.path.tangent_at(0));
    leg.last = in_space(leg, move.path.tangent_at(1));
  } else {
    leg.first = leg.last = in_space(leg, (move.path.to - move.path.from) / leg.plan);
  }
}

/// Along an arc every direction of its plane is met.
double most_along_arc(const Leg& leg, const Vec3& of_axes) {
  const Vec3 worst{leg.plan / leg.length, 0, leg.climb() / leg.length};
  return most_along(worst, {std::min(of_axes.x, of_axes.y), kNoLimit, of_axes.z});
}

Leg leg_of(const Move& move, const AxisLimits& limits) {
  Leg leg;
  leg.move = &move;
  leg.plan = move.path.length();
  leg.length = base::hypot(leg.plan, move.z_to - move.z_from);
  if (leg.length <= 0) return leg;
  leg.arc = move.path.is_arc();
  leg.rapid = is_rapid(move.kind);
  set_directions(leg);
  leg.speed = leg.arc ? most_along_arc(leg, limits.speed) : most_along(leg.first, limits.speed);
  leg.acceleration =
      leg.arc ? most_along_arc(leg, limits.acceleration) : most_along(leg.first, limits.acceleration);
  const double feed = move.feed.mm_per_s();
  leg.programmed = leg.rapid || feed <= 0 ? kNoLimit : feed;
  return leg;
}

}  // namespace

AxisLimits axis_limits(const Machine& machine) {
  const AxisValues speed = axis_speeds(machine), acceleration = axis_accelerations(machine);
  constexpr double kPerSecond = 1 / 60.0;
  return {Vec3{speed[0], speed[1], speed[2]} * kPerSecond,
          {acceleration[0], acceleration[1], acceleration[2]}};
}

double most_along(const Vec3& u, const Vec3& of_axes) {
  double most = kNoLimit;
  if (u.x != 0) most = std::min(most, of_axes.x / std::abs(u.x));
  if (u.y != 0) most = std::min(most, of_axes.y / std::abs(u.y));
  if (u.z != 0) most = std::min(most, of_axes.z / std::abs(u.z));
  return most;
}

std::vector<Leg> legs_of(std::span<const PlannedMove> moves, const Machine& machine) {
  const AxisLimits limits = axis_limits(machine);
  std::vector<Leg> legs;
  legs.reserve(moves.size());
  bool from_rest = true;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    from_rest = from_rest || moves[i].from_rest;
    Leg leg = leg_of(*moves[i].move, limits);
    if (leg.length <= 0) continue;
    if (!leg.rapid && machine.max_feed)
      leg.programmed = std::min(leg.programmed, machine.max_feed->mm_per_s());
    leg.index = i;
    leg.path = moves[i].path;
    leg.from_rest = from_rest;
    from_rest = false;
    legs.push_back(leg);
  }
  return legs;
}

double ramped_time(double length, double v0, double v1, double top, double a) {
  const double peak =
      std::max({v0, v1, std::min(top, std::sqrt(std::max(0.0, a * length + (v0 * v0 + v1 * v1) / 2)))});
  const double up = (peak * peak - v0 * v0) / (2 * a), down = (peak * peak - v1 * v1) / (2 * a);
  const double cruise = std::max(0.0, length - up - down);
  return (peak - v0) / a + (peak - v1) / a + (peak > 0 ? cruise / peak : 0);
}

}  // namespace clearcut::kinematics
