// Fanuc, Haas and Heidenhain. Their planners are not published; the rules are taken from their manuals: look-ahead
// over many blocks, corners by a stated tolerance (Haas G187 E, Heidenhain cycle 32 T; exact stop under G61), speed
// on arcs by the centripetal acceleration (Fanuc parameter 1735), and bell-shaped acceleration with a time constant
// (Fanuc parameters 1769 to 1772): the planned speed is averaged over the time in which the acceleration is built up,
// so that every run from rest to rest takes longer by that time.
#include <algorithm>

#include "kinematics/families.h"
#include "kinematics/pieces.h"

namespace clearcut::kinematics {
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
