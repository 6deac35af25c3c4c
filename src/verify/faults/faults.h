// Turns measurements into faults, each with a sentence.
#pragma once

#include <vector>

#include "model/results/findings.h"
#include "verify/coverage/feature_work.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// A fault of one move; its sentence names the place and the workingstep.
Fault fault_of(const Part& part, FaultKind kind, const CheckedMove& checked, const Place& place, double size,
               const std::string& what);

/// Faults of single moves: gouges, rapids in material, plunges, too deep passes, travel, missing
/// feeds and tools, and wrong states of the control. Successive moves with the same fault give one fault, at
/// the worst of them.
std::vector<Fault> faults_of_moves(const Part& part, const CheckedProgram& program,
                                   const VerifyOptions& options);

/// Conditions from moves: actions left to the operator, and implausible feeds and speeds.
std::vector<Condition> conditions_of_moves(const CheckedProgram& program, const VerifyOptions& options);

/// For walls with draft, the level with the most material left; the floor otherwise.
const LevelCoverage& worst_level(const FeatureWork& work);

/// Whether the layers leave more on a wall with draft than permitted.
bool leaves_steps(const FeatureWork& work, const Scallop& scallop, const Tolerances& tol);

/// Material left in a feature, a wholly uncut feature, or too high steps on a wall with draft.
std::vector<Fault> faults_of_work(const Feature& feature, const FeatureWork& work, const Tolerances& tol);

/// Sorts by severity, then by size.
void sort_worst_first(std::vector<Fault>& faults);

}  // namespace clearcut::verify
