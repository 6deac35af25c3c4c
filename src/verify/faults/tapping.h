// Taps: what they and the spindle do has to follow their thread, with a part or without one.
#pragma once

#include <vector>

#include "model/control.h"
#include "verify/faults/state_faults.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// Checks of every feed move of a tap along its axis below the top: its feed is pitch times speed; into the hole the spindle turns as its
/// hand asks, by its word or by the cycle, out of it the other way; after the way in it comes out at once, at its feed.
std::vector<MoveCheck> tapping_checks(const Part& part, const CheckedProgram& program,
                                      const VerifyOptions& options);

/// `rigid-tap`, at most once: a tap that is not stated to float goes down in a cycle, or in moves, whose feed nothing ties to the spindle.
std::vector<Condition> conditions_of_taps(const CheckedProgram& program, const VerifyOptions& options);

}  // namespace clearcut::verify
