// Grbl 1.1 and grblHAL. Rules: planner.c (junction deviation, limits of the axes along unit vectors, 16 blocks) and
// motion_control.c (arcs as chords within $12), both described in the wiki pages "Grbl v1.1 Configuration" ($11, $12,
// $110 to $122) and in S. Jeon's article "Improving Grbl: cornering algorithm" (2011).
#include "kinematics/families.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "kinematics/pieces.h"

namespace clearcut::kinematics {
namespace {

/// Blocks; one of the 16 is always being filled.
constexpr std::size_t kGrblBlocks = 15;

/// mm; shorter chords are no step of any axis: the control leaves them out.
constexpr double kGrblStepMm = 0.001;

std::size_t grbl_chords(const Leg& leg, const Machine& machine) {
  const double r = leg.move->path.radius(), e = machine.arc_tolerance;
  if (2 * r <= e) return 1;
  // By the tolerance alone the number grows without a bound where the diameter comes near it.
  const double by_tolerance = std::abs(leg.move->path.sweep()) * r / 2 / std::sqrt(e * (2 * r - e));
  return static_cast<std::size_t>(std::min(by_tolerance, leg.plan / kGrblStepMm));
}

}  // namespace

void plan_grbl(std::span<const Leg> legs, const Machine& machine, std::vector<Seconds>& times) {
  const AxisLimits limits = axis_limits(machine);
  std::vector<Piece> pieces = chord_pieces(legs, machine, grbl_chords);
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    const Vec3 turn = pieces[k].first - pieces[k - 1].last;
    const double size = norm(turn);
    const double acceleration =
        size > 0 ? most_along(turn * (1 / size), limits.acceleration) : pieces[k].acceleration;
    pieces[k].entry = std::min(
        pieces[k].entry, junction_speed(pieces[k - 1], pieces[k], acceleration, machine.junction_deviation));
  }
  add_times(pieces, planned_speeds(pieces, kGrblBlocks), times);
}

// Mach3 and Mach4. Rules: "Using Mach3Mill" (constant velocity and exact stop, settings of CV control): in exact stop
// every move ends at rest; in constant velocity a move begins when the previous one begins to slow down, so that both
// together keep the speed.

namespace {

/// s; time in which a piece comes to rest from its reached speed.
double braking_time(const Piece& piece) {
  return std::min(piece.top, std::sqrt(piece.acceleration * piece.length)) / piece.acceleration;
}

bool runs_on(const Leg& leg) {
  return leg.path.mode != PathMode::kExactStop && leg.path.mode != PathMode::kExactPath;
}

}  // namespace

void plan_mach(std::span<const Leg> legs, const Machine&, std::vector<Seconds>& times) {
  std::vector<Piece> pieces = whole_pieces(legs);
  for (Piece& piece : pieces) piece.entry = 0;
  add_times(pieces, planned_speeds(pieces), times);
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    if (legs[k].from_rest || !runs_on(legs[k - 1])) continue;
    const double both = std::min(braking_time(pieces[k - 1]), braking_time(pieces[k]));
    Seconds& time = times[pieces[k - 1].index];
    time = Seconds::of(std::max(0.0, time.seconds() - both));
  }
}

// Marlin 2. Rules: the pages M201, M203, M204 and M205 of its documentation, and of its planner ("Junction
// Deviation", "Classic Jerk") and Configuration_adv.h (MAX_ARC_SEGMENT_MM, MIN_CIRCLE_SEGMENTS, BLOCK_BUFFER_SIZE).

namespace {

constexpr double kChordMm = 1, kShortestChordMm = 0.1;
constexpr double kChordsOfCircle = 72;
constexpr std::size_t kMarlinBlocks = 15;
/// mm and radians; shorter segments with smaller turns count as parts of an arc: v^2 <= a r.
constexpr double kSmallSegment = 1, kSmallTurn = kPi / 4;

std::size_t marlin_chords(const Leg& leg, const Machine&) {
  const double by_length = std::ceil(leg.plan / kChordMm);
  const double by_angle = std::ceil(std::abs(leg.move->path.sweep()) / (2 * kPi) * kChordsOfCircle);
  const double most = std::max(1.0, std::floor(leg.plan / kShortestChordMm));
  return static_cast<std::size_t>(std::min(std::max(by_length, by_angle), most));
}

/// The speed at which no axis changes its speed by more than its permitted jump.
double classic_speed(const Vec3& change, const AxisValues& jump) {
  return most_along(change, {jump[0], jump[1], jump[2]});
}

double marlin_junction(const Piece& before, const Piece& after, const Machine& machine,
                       const AxisLimits& limits) {
  const Vec3 change = after.first - before.last;
  if (machine.speed_jump) return classic_speed(change, *machine.speed_jump);
  const double size = norm(change);
  if (size == 0) return kNoLimit;
  const double a = std::min(after.acceleration, most_along(change * (1 / size), limits.acceleration));
  double speed = junction_speed(before, after, a, machine.junction_deviation);
  const double turn = base::acos(std::clamp(dot(before.last, after.first), -1.0, 1.0));
  if (after.length < kSmallSegment && turn < kSmallTurn && turn > 0)
    speed = std::min(speed, std::sqrt(a * after.length / turn));
  return speed;
}

}  // namespace

void plan_marlin(std::span<const Leg> legs, const Machine& machine, std::vector<Seconds>& times) {
  const AxisLimits limits = axis_limits(machine);
  std::vector<Piece> pieces = chord_pieces(legs, machine, marlin_chords);
  for (Piece& piece : pieces) piece.acceleration = std::min(piece.acceleration, machine.acceleration);
  for (std::size_t k = 1; k < pieces.size(); ++k)
    pieces[k].entry = std::min(pieces[k].entry, marlin_junction(pieces[k - 1], pieces[k], machine, limits));
  add_times(pieces, planned_speeds(pieces, kMarlinBlocks), times);
}

// Fanuc, Haas and Heidenhain. Their planners are not published; the rules are taken from their manuals: look-ahead
// over many blocks, corners by a stated tolerance (Haas G187 E, Heidenhain cycle 32 T; exact stop under G61), speed
// on arcs by the centripetal acceleration (Fanuc parameter 1735), and bell-shaped acceleration with a time constant
// (Fanuc parameters 1769 to 1772): the planned speed is averaged over the time in which the acceleration is built up,
// so that every run from rest to rest takes longer by that time.

namespace {

/// s; time in which the acceleration is built up if the machine states no jerk.
constexpr double kBellTime = 0.05;
/// mm/s; a slower corner is a stop.
constexpr double kAtRest = 1e-9;

double corner_tolerance(const Leg& leg, const Machine& machine) {
  switch (leg.path.mode) {
    case PathMode::kExactStop:
      return 0;
    case PathMode::kTolerance:
      return leg.path.tolerance_mm.value_or(machine.junction_deviation);
    case PathMode::kUnstated:
    case PathMode::kExactPath:
    case PathMode::kContinuous:
    case PathMode::kSmoothness:
      break;
  }
  return machine.path_tolerance.value_or(machine.junction_deviation);
}

}  // namespace

void plan_jerk_limited(std::span<const Leg> legs, const Machine& machine, std::vector<Seconds>& times) {
  std::vector<Piece> pieces = whole_pieces(legs);
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    const double tolerance = corner_tolerance(legs[k - 1], machine);
    const double a = std::min(pieces[k - 1].acceleration, pieces[k].acceleration);
    // Under exact stop every block ends at rest, regardless of the next one.
    const double corner = tolerance > 0 ? junction_speed(pieces[k - 1], pieces[k], a, tolerance) : 0;
    pieces[k].entry = std::min(pieces[k].entry, corner);
  }
  const std::vector<double> speeds = planned_speeds(pieces);
  add_times(pieces, speeds, times);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (speeds[k + 1] > kAtRest) continue;
    const double bell = machine.jerk ? pieces[k].acceleration / *machine.jerk : kBellTime;
    Seconds& time = times[pieces[k].index];
    time = time + Seconds::of(bell);
  }
}

}  // namespace clearcut::kinematics
