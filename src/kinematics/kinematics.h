// Time of moves by simple rules: acceleration along the path with slowing down in corners, and the milling time of
// equation 9 of CPO-rho.
#pragma once

#include <span>
#include <vector>

#include "base/units.h"
#include "model/machine.h"
#include "model/move.h"
#include "model/results/published_time.h"

namespace clearcut::kinematics {

/// Time of each move when they are run one after the other, from rest to rest, with full look-ahead.
///
/// Model   Trapezoidal speed along each move at machine.acceleration. Between moves the speed obeys the
///         junction deviation rule of Grbl: v^2 = a d s / (1 - s), s = sin(theta / 2), theta the angle
///         between the moves (pi: straight on). On arcs v^2 <= a r. Rapids and feed moves without a feed run
///         at machine.rapid.
/// Cost    O(n).
std::vector<Seconds> move_times(std::span<const Move> moves, const Machine& machine);

/// Sum of move_times.
Seconds kinematic_time(std::span<const Move> moves, const Machine& machine);

/// Seconds from standstill to standstill over `length` mm at no more than `speed` mm/s.
double travel_time(double length, double speed, double acceleration);

/// Length / programmed speed, as most programs estimate it.
Seconds naive_time(const Move& move, const Machine& machine);

/// Equation 9 of CPO-rho for a toolpath. Level feed moves count: contours, passages between them and links at depth, the segments of the result file.
/// Plunges, ramps, retracts and rapids do not; feed moves without a feed have no time.
PublishedTime published_time(const Toolpath& toolpath);

}  // namespace clearcut::kinematics
