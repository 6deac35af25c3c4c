// Moves so far from the work that a sign, a digit or a decimal point must be wrong.
#pragma once

#include <optional>

#include "model/control.h"
#include "model/move.h"
#include "model/part.h"

namespace clearcut::pipeline {

/// The condition `far-move` for the farthest move: below the top of the work, if it is more than 50 mm plus the
/// cutter's width beside the stock (or the features, if no stock is stated); above the top, if more than 2 m away.
std::optional<Condition> far_move(const Part& part, const Toolpath& toolpath);

}  // namespace clearcut::pipeline
