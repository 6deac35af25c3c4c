// Chooses the tool for a hole among the available ones, and the width of the required pilot hole.
#pragma once

#include <functional>
#include <vector>

#include "model/part.h"

namespace clearcut::resolve {

/// Permitted widths of a pilot hole, mm.
struct Pilot {
  double least = 0, best = 0, most = 0;
};

/// Before a thread: from the minor diameter to its tolerance; best the usual drill, d - P.
Pilot pilot_before(const Thread& thread);
/// Before a reamer or a boring bar.
Pilot pilot_before(const HoleForm& hole, const Tool& tool);

/// Index of the first tool for which `does` is true; -1 for none.
int tool_where(const std::vector<Tool>& tools, const std::function<bool(const Tool&)>& does);

/// The reamer, boring bar, counterbore or drill of the hole's width required by its kind; -1 for none.
int tool_of_kind(const std::vector<Tool>& tools, const HoleForm& hole);
int tap_for(const std::vector<Tool>& tools, const Thread& thread);
/// The widest thread mill for the thread's pitch and minor diameter; around a boss the narrowest one for its pitch.
int thread_mill_for(const std::vector<Tool>& tools, const Thread& thread, bool external = false);
/// The smallest cone as wide as the hole: countersinks rather by a chamfer mill, spots by a spot drill.
int cone_for(const std::vector<Tool>& tools, const HoleForm& hole, Radians lean);
/// The drill nearest to the best width in the permitted range.
int drill_for(const std::vector<Tool>& tools, const Pilot& pilot);
/// The widest mill able to bore the best width along a helix, or to clear it.
int mill_for(const std::vector<Tool>& tools, const Pilot& pilot);

/// Whether a tool that makes the feature, which does not go through, comes out below the material with its tip at z.
bool comes_out_below(const Part& part, const Feature& feature, double z);

/// Whether the floor of the feature lies farther below the material than the surface below the board bears.
bool lies_below(const Part& part, const Feature& feature, double floor);

/// Where the feature itself ends: above the end of a tool that goes deeper.
double asked_floor(const Feature& feature);

}  // namespace clearcut::resolve
