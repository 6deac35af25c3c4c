// Which of the tools at hand makes a hole, and how wide the hole before it has to be.
#pragma once

#include <functional>
#include <vector>

#include "model/part.h"

namespace clearcut::resolve {

/// Widths that the hole before another may have, mm.
struct Pilot {
  double least = 0, best = 0, most = 0;
};

/// Before a thread: from the minor diameter to its tolerance; best the usual drill, d - P.
Pilot pilot_before(const Thread& thread);
/// Before a reamer or a boring bar.
Pilot pilot_before(const HoleForm& hole, const Tool& tool);

/// Index of the first tool that does; -1 for none.
int tool_where(const std::vector<Tool>& tools, const std::function<bool(const Tool&)>& does);

/// The reamer, boring bar, counterbore or drill of the hole's width that its kind asks for; -1 for none.
int tool_of_kind(const std::vector<Tool>& tools, const HoleForm& hole);
int tap_for(const std::vector<Tool>& tools, const Thread& thread);
/// The widest that fits the thread's pitch and its minor diameter; about a boss the narrowest that fits its pitch.
int thread_mill_for(const std::vector<Tool>& tools, const Thread& thread, bool external = false);
/// The smallest cone as wide as the hole: countersinks rather by a chamfer mill, spots by a spot drill.
int cone_for(const std::vector<Tool>& tools, const HoleForm& hole, Radians lean);
/// The drill nearest to the best width among those that may be.
int drill_for(const std::vector<Tool>& tools, const Pilot& pilot);
/// The widest mill that bores the best width along a helix, or clears it.
int mill_for(const std::vector<Tool>& tools, const Pilot& pilot);

}  // namespace clearcut::resolve
