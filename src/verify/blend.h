// What a control may cut off a corner of the path while it keeps to its tolerance.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "verify/checked_move.h"

namespace clearcut::verify {

/// Where `before` ends and `after` begins: two lines from the one to the other, through the place that is `tolerance` mm from the
/// corner on the inside of the turn. The control's way lies between them and the path. Nothing where the path goes on
/// smoothly, or one of the moves is a rapid or vertical.
std::optional<std::array<Move, 2>> rounded_corner(const JudgedMove& before, const JudgedMove& after,
                                                  double tolerance);

/// The greatest tolerance with which a control may round a corner of these feed moves, mm.
double corner_tolerance(std::span<const JudgedMove> moves);

}  // namespace clearcut::verify
