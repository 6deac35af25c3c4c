// Threads: a milled one follows the formula of its helix; with taps, motion and spindle follow the thread, with or
// without a part.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/control.h"
#include "verify/faults/state_faults.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// A fault of a thread.
struct ThreadDefect {
  enum class Kind { kNothing, kShallow, kNarrow, kHelix } kind = Kind::kHelix;
  double size = 0;  ///< mm; size of the thread's error
  std::string text;
  int line = 0;
};

/// Checks the moves of thread mills, including rapids, about the thread's axis; `moves` in the order of the program.
///
/// Helix   At the angle a about the axis a right-hand thread with the pitch P is at the height z0 + P a / (2 pi),
///         plus any number of pitches; for a left-hand thread a counts in the opposite sense. Wherever the mill
///         reaches farther from the axis than the minor radius, it must be on this helix: on the turns this proves
///         radius, pitch and hand; on the moves in and out it proves that they do not cut through the thread.
/// Depth   Turns at the full radius must follow each other from full_z to the top; of multiple rows of teeth
///         the lowest and the highest count.
std::vector<ThreadDefect> defects_of_thread(const Feature& feature,
                                            const std::vector<const CheckedMove*>& moves);

/// Checks of every feed move of a tap along its axis below the top: its feed is pitch times speed; into the hole the
/// spindle turns according to the thread's hand, by its word or by the cycle, and in reverse out of the hole; after
/// the descent the tap retracts at once, at its feed.
std::vector<MoveCheck> tapping_checks(const Part& part, const CheckedProgram& program,
                                      const VerifyOptions& options);

/// `rigid-tap`, at most once: a tap not stated as floating descends in a cycle, or in moves, without synchronisation
/// of feed and spindle.
std::vector<Condition> conditions_of_taps(const CheckedProgram& program, const VerifyOptions& options);

}  // namespace clearcut::verify
