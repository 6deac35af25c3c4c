// The additional material that a control may cut by rounding a corner of the path within its tolerance.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// Two lines from a point of `before` to a point of `after`, through the point `tolerance` mm from the corner on the
/// inside of the turn. The control's path is between these lines and the programmed one. Nothing if the moves join
/// smoothly, or if one of them is a rapid or vertical.
std::optional<std::array<Move, 2>> rounded_corner(const CheckedMove& before, const CheckedMove& after,
                                                  double tolerance);

/// mm; the greatest tolerance of a control's corner rounding between these feed moves.
double corner_tolerance(std::span<const CheckedMove> moves);

}  // namespace clearcut::verify
