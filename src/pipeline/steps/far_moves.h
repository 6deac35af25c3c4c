// Moves that lead so far away from the work that a sign, a digit or a decimal point must be wrong.
#pragma once

#include <optional>

#include "model/control.h"
#include "model/move.h"
#include "model/part.h"

namespace clearcut::pipeline {

/// The condition `far-move` for the move that is farthest away: below the top of the work more than 50 mm and the cutter's width
/// beside the stock, or the features where no stock is stated; above it more than 2 m.
std::optional<Condition> far_move(const Part& part, const Toolpath& toolpath);

}  // namespace clearcut::pipeline
