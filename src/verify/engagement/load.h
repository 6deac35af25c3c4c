// What the cutter meets along the program: engagement, depth of cut, rapids through material.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "base/progress_meter.h"
#include "base/tolerances.h"
#include "model/part.h"
#include "model/work_material.h"
#include "verify/part/finished_part.h"
#include "verify/program/checked_move.h"
#include "verify/program/load_reference.h"

namespace clearcut::verify {

struct LoadOptions {
  Tolerances tol;
  std::optional<double> limit_deg;           ///< greater engagement is counted separately
  std::optional<WorkMaterial> material;      ///< absent: no forces are computed
  std::stop_token cancel;                    ///< asked before each move
  const LoadReference* reference = nullptr;  ///< null: loads are compared with none
  ProgressMeter* meter = nullptr;  ///< counts the samples of each move that was measured; see samples_of
  const FinishedPart* finished = nullptr;  ///< the part as it has to come out; null: nobody states it
};

/// About how many samples of engagement the moves are measured at: what measuring them costs.
std::size_t samples_of(const Part& part, const std::vector<CheckedMove>& moves);

/// Runs the program through the stock, move by move, and fills every move's `load`.
///
/// Engagement is measured at the middle of steps of at most R/10 and 0.25 mm, and on both sides of corners,
/// with a circle smaller than the cutter by kResidual, so that touching a wall that is already cut does not
/// count. It counts on all moves that are not vertical. What an entry takes of its own (EntryWatch) is measured apart. Rapids and
/// plunges are checked with the whole area of their cutter.
///
/// Cost    O(length / step * moves near).
void measure_load(const Part& part, std::vector<CheckedMove>& moves, const LoadOptions& options);

/// The same as tasks for up to `threads` threads, which together fill what measure_load fills: each runs the program as far
/// as its part of the moves, which alone it measures. The load does not depend on how many there are. References are kept.
std::vector<std::function<void()>> load_tasks(const Part& part, std::vector<CheckedMove>& moves,
                                              const LoadOptions& options, int threads);

}  // namespace clearcut::verify
