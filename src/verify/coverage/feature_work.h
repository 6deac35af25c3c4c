// What a program has to cut in each feature, and the proof whether it did.
#pragma once

#include <functional>
#include <vector>

#include "verify/coverage/coverage.h"
#include "verify/part/finished_parts.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// Coverage of a feature down to one height.
struct LevelCoverage {
  double z = 0;
  bool any_cut = false;  ///< some feed move reaches this height there
  Coverage coverage;
  const Tool* tool = nullptr;  ///< whose layer it is
};

/// One feature of the workplan, with the finest requirement of all its operations.
struct FeatureWork {
  int feature = 0;
  int last_workingstep = 0;
  double smallest_radius = 0;  ///< mm; of its smallest cutter
  double smallest_flat = 0;    ///< mm; of the flat end of that cutter
  bool ends_in_point = false;  ///< that cutter, where it has no flat end
  double greatest_radius = 0;
  const Tool* smallest = nullptr;  ///< that cutter
  double allowance_side = 0;
  double allowance_floor = 0;
  std::optional<double> scallop;  ///< mm; greatest step allowed on walls with draft, square to the wall
  /// Of walls with draft, where layers alone would leave more than that: whether no more is left at any height all the same, because moves
  /// between the layers cut the walls.
  bool is_cut_between_layers = false;
  LevelCoverage floor;           ///< down to the floor plus its allowance
  std::optional<Place> deepest;  ///< end of the lowest feed move in it, only where none reaches the floor
  /// Down to each layer above the floor, of the steps that leave the least on walls. Filled for walls with
  /// draft, where each layer has an outline of its own, and otherwise only if something is left on the floor:
  /// a cutter that reaches the floor has cleared what stood above it.
  std::vector<LevelCoverage> layers;
};

/// What layers leave on the feature's walls, square to the wall, by the shape of their cutters, whose ends run along the outline at
/// their height; only for walls with draft, and once the work has been checked. `asked_mm` is that of tol where no operation says.
std::optional<Scallop> scallop_of(const Feature& feature, const FeatureWork& work, const Tolerances& tol);

/// The features' works, in the order of their first workingsteps.
std::vector<FeatureWork> works_of(const Part& part);

/// Checks all features on up to options.threads threads, together with `beside`, independent tasks for the
/// same threads. The result does not depend on the number of threads.
void check_works(const Part& part, const FinishedParts& finished, const CheckedProgram& program,
                 const VerifyOptions& options, std::vector<FeatureWork>& works,
                 std::vector<std::function<void()>> beside);

/// The coverage of a work's floor where each move may lie up to `off` mm off its path, in any direction: what then is left for certain and
/// what may be. Keeps references to what it was made from.
using FloorCheck = std::function<LevelCoverage(const FeatureWork& work, double off)>;
FloorCheck floor_check(const Part& part, const FinishedParts& finished, const CheckedProgram& program,
                       const VerifyOptions& options);

}  // namespace clearcut::verify
