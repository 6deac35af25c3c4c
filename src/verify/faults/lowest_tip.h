// Lowest height of a cutter's tip while the cutter covers a place.
#pragma once

#include <optional>

#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// mm; the lowest height of the tip while the cutter's disc covers p; absent if it never does. Exact for lines and
/// arcs.
std::optional<double> lowest_tip(const CheckedMove& checked, Vec2 p);

}  // namespace clearcut::verify
