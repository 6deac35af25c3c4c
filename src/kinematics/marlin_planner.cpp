// Marlin 2. Rules: the pages M201, M203, M204 and M205 of its documentation, and of its planner ("Junction
// Deviation", "Classic Jerk") and Configuration_adv.h (MAX_ARC_SEGMENT_MM, MIN_CIRCLE_SEGMENTS, BLOCK_BUFFER_SIZE).
#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "kinematics/families.h"
#include "kinematics/pieces.h"

namespace clearcut::kinematics {
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

}  // namespace clearcut::kinematics
