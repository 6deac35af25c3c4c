// What a program was to cut in each feature, and the proof whether it did.
#pragma once

#include <functional>
#include <vector>

#include "verify/checked_move.h"
#include "verify/coverage/coverage.h"
#include "verify/verify.h"

namespace clearcut::verify {

/// Coverage of a feature down to one height.
struct LevelCoverage {
  double z = 0;
  bool any_cut = false;  ///< some feed move reaches this depth there
  Coverage coverage;
};

/// One feature of the workplan with the finest that any of its operations is to do.
struct FeatureWork {
  int feature = 0;
  int last_workingstep = 0;
  double smallest_radius = 0;  ///< of its cutters, mm
  double smallest_flat = 0;    ///< of the flat end of that cutter
  double greatest_radius = 0;
  double allowance_side = 0;
  double allowance_floor = 0;
  std::optional<double> scallop;  ///< greatest step allowed on leaning walls, square to the wall
  LevelCoverage floor;            ///< down to the floor less its allowance
  /// Down to each layer above the floor of the steps that leave no more on the walls than any: filled for leaning
  /// walls, where each layer has an outline of its own, and otherwise only when something is left on the floor (a
  /// cutter that reaches the floor has cleared what stands above it).
  std::vector<LevelCoverage> layers;
};

/// What the layers leave on the walls of the feature: once its works are judged, and where walls lean.
std::optional<Scallop> scallop_of(const Feature& feature, const FeatureWork& work);

/// In order of each feature's first workingstep.
std::vector<FeatureWork> works_of(const Part& part);

/// Judges all features on up to options.threads threads, together with `beside` (independent work to share
/// them with). The result does not depend on the number of threads.
void judge_works(const Part& part, const FinishedPart& finished, const JudgedProgram& program,
                 const VerifyOptions& options, std::vector<FeatureWork>& works,
                 std::vector<std::function<void()>> beside);

}  // namespace clearcut::verify
