// Turns what was measured into faults with a sentence each.
#pragma once

#include <vector>

#include "model/results/findings.h"
#include "verify/checked_move.h"
#include "verify/coverage/feature_work.h"
#include "verify/verify.h"

namespace clearcut::verify {

/// A fault of one move, with the place and whose work it is in its sentence.
Fault fault_of(const Part& part, FaultKind kind, const JudgedMove& judged, const Place& place, double size,
               const std::string& what);

/// Faults of single moves: gouges, rapids in material, plunges, too deep passes, travel, missing feeds and
/// tools, and what the control holds wrong while they cut. Successive moves with the same fault give one fault at the worst of them.
std::vector<Fault> faults_of_moves(const Part& part, const JudgedProgram& program,
                                   const VerifyOptions& options);

/// The level at which most is left, of leaning walls; the floor of others.
const LevelCoverage& worst_level(const FeatureWork& work);

/// Material left in a feature, nothing cut at all, or steps on a leaning wall that are too high.
std::vector<Fault> faults_of_work(const Feature& feature, const FeatureWork& work, const Tolerances& tol);

/// The kinds that break things first, then by size.
void sort_worst_first(std::vector<Fault>& faults);

}  // namespace clearcut::verify
