#include "kinematics/kinematics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"
#include "base/error.h"
#include "base/tolerances.h"

namespace clearcut::kinematics {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

struct Direction {
  double x = 0, y = 0, z = 0;
};

double dot(const Direction& a, const Direction& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// A move of positive length, with its frequently used values.
struct Run {
  std::size_t index = 0;
  double plan = 0;        ///< length of its path, mm
  double length = 0;      ///< mm
  double top = 0;         ///< mm/s
  Direction first, last;  ///< directions of travel at its beginning and end
};

/// Unit direction of travel at an end of a move.
Direction direction_at(const Move& move, Vec2 tangent, double plan, double space) {
  const double dz = move.z_to - move.z_from;
  const Vec2 u = tangent * (plan / space);
  return {u.x, u.y, dz / space};
}

/// mm/s: the programmed speed, or the speed allowed by the machine or the arc's curvature.
double nominal_speed(const Move& move, double plan, const Machine& machine) {
  const double programmed = move.feed.mm_per_s();
  double speed = is_rapid(move.kind) || programmed <= 0 ? machine.rapid.mm_per_s() : programmed;
  if (!is_rapid(move.kind) && machine.max_feed) speed = std::min(speed, machine.max_feed->mm_per_s());
  if (!move.path.is_arc()) return speed;
  // The radius of curvature of a helix is r / cos^2 of its climb.
  const double climb = (move.z_to - move.z_from) / plan;
  return std::min(speed, std::sqrt(machine.acceleration * move.path.radius() * (1 + climb * climb)));
}

Run run_of(const Move& move, const Machine& machine) {
  Run run;
  run.plan = move.path.length();
  run.length = base::hypot(run.plan, move.z_to - move.z_from);
  if (run.length <= 0) return run;
  run.top = nominal_speed(move, run.plan, machine);
  if (move.is_vertical()) {
    run.first = run.last = {0, 0, move.z_to > move.z_from ? 1.0 : -1.0};
  } else if (move.path.is_arc()) {
    run.first = direction_at(move, move.path.tangent_at(0), run.plan, run.length);
    run.last = direction_at(move, move.path.tangent_at(1), run.plan, run.length);
  } else {
    run.first = run.last =
        direction_at(move, (move.path.to - move.path.from) / run.plan, run.plan, run.length);
  }
  return run;
}

/// Square of the greatest speed through the corner between two moves (Grbl, planner.c: junction deviation).
double junction_speed_squared(const Run& before, const Run& after, const Machine& machine) {
  const double straightness = std::clamp(dot(before.last, after.first), -1.0, 1.0);
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
  std::vector<Run> runs;  // moves of no length take no time and do not stop the others
  runs.reserve(moves.size());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    runs.push_back(run_of(moves[i], machine));
    runs.back().index = i;
    if (runs.back().length <= 0) runs.pop_back();
  }
  const double a = machine.acceleration;
  std::vector<double> entry(runs.size() + 1, 0.0);  // squares of the speeds between moves
  for (std::size_t k = 1; k < runs.size(); ++k) {
    const Run &before = runs[k - 1], &after = runs[k];
    const double corner = junction_speed_squared(before, after, machine);
    entry[k] = std::min({corner, before.top * before.top, after.top * after.top});
  }
  for (std::size_t k = runs.size(); k-- > 0;)
    entry[k] = std::min(entry[k], entry[k + 1] + 2 * a * runs[k].length);
  for (std::size_t k = 0; k < runs.size(); ++k)
    entry[k + 1] = std::min(entry[k + 1], entry[k] + 2 * a * runs[k].length);
  std::vector<Seconds> times(moves.size());
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const Run& run = runs[k];
    times[run.index] =
        Seconds::of(trapezoid_time(run.length, std::sqrt(entry[k]), std::sqrt(entry[k + 1]), run.top, a));
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

namespace {

/// Degrees. Smaller changes of direction come from rounding.
constexpr double kStraightOn = 0.1;

bool is_segment(const Move& move) {
  return !is_rapid(move.kind) && !move.is_vertical() && move.z_from == move.z_to;
}

bool turns_between(const Move& before, const Move& after) {
  if (distance(before.path.to, after.path.from) > kRoundingMm) return false;
  const Vec2 in = before.path.tangent_at(1), out = after.path.tangent_at(0);
  return std::abs(base::atan2(cross(in, out), dot(in, out))) * 180 / kPi > kStraightOn;
}

void add(PublishedTime& time, const Move& move) {
  const double length = move.path.length(), feed = move.feed.mm_per_min();
  time.length_mm += length;
  if (feed <= 0) return;
  time.cutting_s += 60 * length / feed;
  if (time.slowest.mm_per_min() <= 0 || feed < time.slowest.mm_per_min()) time.slowest = move.feed;
  if (feed > time.fastest.mm_per_min()) time.fastest = move.feed;
}

}  // namespace

PublishedTime published_time(const Toolpath& toolpath) {
  PublishedTime time;
  for (const Section& section : toolpath.sections) {
    const Move* before = nullptr;
    for (const Move& move : section.moves) {
      const bool counts = is_segment(move);
      if (counts) add(time, move);
      if (counts && before != nullptr && turns_between(*before, move)) ++time.discontinuities;
      before = counts ? &move : nullptr;
    }
  }
  return time;
}

}  // namespace clearcut::kinematics
