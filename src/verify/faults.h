// Turns what was measured into faults with a sentence each.
#pragma once

#include <vector>

#include "toolpath/findings.h"
#include "verify/coverage.h"
#include "verify/judged_move.h"
#include "verify/verify.h"

namespace clearcut {

/// Faults of single moves: gouges, rapids in material, plunges, too deep passes, travel, missing feeds and
/// tools. Successive moves with the same fault give one fault at the worst of them.
std::vector<Fault> faults_of_moves(const Part& part, const JudgedProgram& program,
                                   const VerifyOptions& options);

/// Material left in a feature, or nothing cut at all. `at` is the depth judged.
std::vector<Fault> faults_of_coverage(const Feature& feature, const Coverage& coverage, bool any_cut,
                                      double z, const Tolerances& tol);

/// The kinds that break things first, then by size.
void sort_worst_first(std::vector<Fault>& faults);

}  // namespace clearcut
