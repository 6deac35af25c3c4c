// Checks a milled thread against the formula of its helix.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verify/program/checked_move.h"

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
/// Depth   Turns at the full radius must follow each other from full_z to the top; multiple rows of teeth count with
///         their length.
std::vector<ThreadDefect> defects_of_thread(const Feature& feature,
                                            const std::vector<const CheckedMove*>& moves);

}  // namespace clearcut::verify
