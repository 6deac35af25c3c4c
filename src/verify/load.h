// What the cutter meets along the program: engagement, depth of cut, rapids through material.
#pragma once

#include <optional>
#include <stop_token>

#include "base/tolerances.h"
#include "model/part.h"
#include "model/work_material.h"
#include "verify/checked_move.h"

namespace clearcut::verify {

struct LoadOptions {
  Tolerances tol;
  std::optional<double> limit_deg;       ///< engagement above this is counted apart
  std::optional<WorkMaterial> material;  ///< of the work; none: no forces
  std::stop_token cancel;                ///< looked at before each move
};

/// Runs the program through the stock, move by move, and fills every move's `load`.
///
/// Contact is measured at the middle of steps of at most R/10 and 0.25 mm, and on both sides of corners, on a
/// circle kFilm smaller than the cutter, so that grazing a wall that is already cut is no contact. Engagement
/// counts level moves; descending ones, and level ones over the ramps just run, are entries.
///
/// Cost    O(length / step * moves near).
void measure_load(const Part& part, std::vector<JudgedMove>& moves, const LoadOptions& options);

}  // namespace clearcut::verify
