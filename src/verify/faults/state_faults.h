// What the control and the tool may not be asked to do while a move cuts: tool length, spindle, entries, depth.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/results/findings.h"
#include "verify/checked_move.h"
#include "verify/verify.h"

namespace clearcut::verify {

/// What one move is found guilty of, as far as one kind of fault is asked.
using MoveJudge = std::function<std::optional<Fault>(const JudgedMove&)>;

/// One judge for each rule. They keep references to all arguments. Only moves that take material away are judged.
std::vector<MoveJudge> state_judges(const Part& part, const JudgedProgram& program,
                                    const VerifyOptions& options);

/// Steepest way into material of a cutter that may not plunge, where its operation states no angle: tangent of 15 degrees.
inline constexpr double kSteepestEntry = 0.2679;

}  // namespace clearcut::verify
