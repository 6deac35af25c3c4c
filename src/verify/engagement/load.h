// Load of the cutter along the program: engagement, depth of cut, rapids through material; cutting force, power,
// energy and wear from engagement and material.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "base/progress.h"
#include "base/tolerances.h"
#include "model/part.h"
#include "model/work_material.h"
#include "stock/material.h"
#include "verify/part/finished_part.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// Engagement of the cutter on a short piece of a level move.
struct CutSample {
  stock::CutterEngagement contact;
  double axial = 0;   ///< mm of depth in material
  double length = 0;  ///< mm of path; 0: a point only compared with the worst one
  Place at;
};

/// Adds a piece to the forces of a move. Nothing if spindle speed, teeth or feed are unknown. Source:
/// docs/forces.md.
void add_forces(CheckedMove& checked, const CutSample& sample, const WorkMaterial& material);

/// The wall of the finished part that bends most if half of `force` N, the share pressing on the wall, acts on its
/// top; nothing if no wall bends by more than 0.02 mm. Considers walls up to 20 mm thick. O(walls^2); nothing for
/// more than 3000 walls.
std::optional<ThinWall> thinnest_wall(const FinishedPart& part, double force, const WorkMaterial& material);

/// N; greatest force of the move, 0 if it does not cut.
inline float force_of(const CheckedMove& checked) {
  return checked.load.forces ? static_cast<float>(checked.load.forces->max_force_n) : 0;
}

struct LoadOptions {
  Tolerances tol;
  std::optional<double> limit_deg;           ///< greater engagement is counted separately
  std::optional<WorkMaterial> material;      ///< absent: no forces are computed
  std::stop_token cancel;                    ///< asked before each move
  const LoadReference* reference = nullptr;  ///< null: loads are compared with none
  ProgressMeter* meter = nullptr;            ///< counts the samples of each measured move; see samples_of
  const FinishedPart* finished = nullptr;    ///< the finished part; null: not stated
};

/// Approximate number of engagement samples of the moves: a measure of the cost.
std::size_t samples_of(const Part& part, const std::vector<CheckedMove>& moves);

/// Runs the program through the stock, move by move, and fills every move's `load`.
///
/// Engagement is measured at the middle of steps of at most R/10 and 0.25 mm, and on both sides of corners,
/// with a circle smaller than the cutter by kResidual, so that touching a finished wall does not count. All
/// non-vertical moves count. An entry's own material (EntryWatch) is measured separately. Rapids and plunges are
/// checked with the whole area of their cutter.
///
/// Cost    O(length / step * moves near).
void measure_load(const Part& part, std::vector<CheckedMove>& moves, const LoadOptions& options);

/// The same as tasks for up to `threads` threads, which together give the result of measure_load: each runs the
/// program up to its part of the moves and measures only this part. The load does not depend on the number of tasks.
/// References are kept.
std::vector<std::function<void()>> load_tasks(const Part& part, std::vector<CheckedMove>& moves,
                                              const LoadOptions& options, int threads);

}  // namespace clearcut::verify
