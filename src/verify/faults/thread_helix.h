// A milled thread against the formula of its helix.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verify/checked_move.h"

namespace clearcut::verify {

/// What is wrong with a thread.
struct ThreadDefect {
  enum class Kind { kNothing, kShallow, kNarrow, kHelix } kind = Kind::kHelix;
  double size = 0;  ///< mm
  std::string text;
  int line = 0;
};

/// Judges the feed moves of thread mills about the thread's axis (in the order of the program).
///
/// A place on a thread at the angle a about its axis lies at the height z0 + P a / 2 pi, for a right-hand thread; of a
/// left-hand one a counts the other way. Every place of the paths at which the mill reaches deeper into the wall than the
/// minor diameter has to lie there, to within a pitch (many rows, many turns): on the whole turns that gives radius, pitch
/// and hand; on the ways in and out, that nothing is cut across. Where whole turns at the full radius have been (with many
/// rows of teeth a mill covers as much height as these), the thread is full: from its lower end to its top.
std::vector<ThreadDefect> defects_of_thread(const Feature& feature,
                                            const std::vector<const JudgedMove*>& moves);

}  // namespace clearcut::verify
