// Taps: their motion and the spindle must follow their thread, with or without a part.
#pragma once

#include <vector>

#include "model/control.h"
#include "verify/faults/state_faults.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// Checks of every feed move of a tap along its axis below the top: its feed is pitch times speed; into the hole the
/// spindle turns according to the thread's hand, by its word or by the cycle, and in reverse out of the hole; after
/// the descent the tap retracts at once, at its feed.
std::vector<MoveCheck> tapping_checks(const Part& part, const CheckedProgram& program,
                                      const VerifyOptions& options);

/// `rigid-tap`, at most once: a tap not stated as floating descends in a cycle, or in moves, without synchronisation
/// of feed and spindle.
std::vector<Condition> conditions_of_taps(const CheckedProgram& program, const VerifyOptions& options);

}  // namespace clearcut::verify
