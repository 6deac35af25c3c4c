// Grbl 1.1 and grblHAL. Rules: planner.c (junction deviation, limits of the axes along unit vectors, 16 blocks) and
// motion_control.c (arcs as chords within $12), both described in the wiki pages "Grbl v1.1 Configuration" ($11, $12,
// $110 to $122) and in S. Jeon's article "Improving Grbl: cornering algorithm" (2011).
#include <algorithm>
#include <cmath>

#include "kinematics/families.h"
#include "kinematics/pieces.h"

namespace clearcut::kinematics {
namespace {

/// Blocks; one of the 16 is always being filled.
constexpr std::size_t kGrblBlocks = 15;

std::size_t grbl_chords(const Leg& leg, const Machine& machine) {
  const double r = leg.move->path.radius(), e = machine.arc_tolerance;
  if (2 * r <= e) return 1;
  return static_cast<std::size_t>(std::abs(leg.move->path.sweep()) * r / 2 / std::sqrt(e * (2 * r - e)));
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

}  // namespace clearcut::kinematics
