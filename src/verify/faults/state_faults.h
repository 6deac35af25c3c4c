// Checks the state of control and tool during cutting moves: tool length, spindle,
// entries, depth.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/results/findings.h"
#include "verify/faults/hand_work.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// Returns the fault of one move with respect to one rule, if there is one.
using MoveCheck = std::function<std::optional<Fault>(const CheckedMove&)>;

/// Manual actions of the checked program and of the earlier one.
struct HandWorks {
  HandWork own, earlier;

  HandWorks(const CheckedProgram& program, const VerifyOptions& options);
  const HandWork& of(const CheckedMove& checked) const { return checked.earlier ? earlier : own; }
  /// Conditions of both programs.
  std::vector<Condition> conditions() const;
};

/// One function for each rule. They keep references to all arguments. Only moves that remove material have
/// faults.
std::vector<MoveCheck> state_checks(const Part& part, const CheckedProgram& program,
                                    const VerifyOptions& options, const HandWorks& hands);

/// mm; greatest depth below the stock of a through cut if no part states the through features. A greater depth is a
/// fault, a smaller one a condition.
inline constexpr double kUsualBreakthrough = 1;

/// Tangent of 15 degrees: the steepest entry of a cutter that must not plunge, unless an operation with it states
/// a steeper one.
inline constexpr double kSteepestEntry = 0.2679;

}  // namespace clearcut::verify
