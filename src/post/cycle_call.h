// Holes as Sinumerik's cycles: CYCLE81 to CYCLE85 and CYCLE840, called at each place by MCALL.
#pragma once

#include <string>

#include "model/part.h"
#include "post/words/drill_cycle.h"
#include "post/words/print_grid.h"

namespace clearcut::post {

/// Data of a call in addition to the hole itself.
struct CycleCall {
  const DrillBlock& hole;
  const Tool* tap = nullptr;  ///< null for other tools
  long long spindle_rpm = 0;
  bool clockwise = true;  ///< the spindle before and after the cycle
  double dwell_s = 0;     ///< at the bottom
};

/// Whether a cycle of the control does exactly what the moves of the hole do. In chip breaking the cycle rises at the
/// feed and not at the rapid, so those holes are written as moves; so are holes with a dwell after the pecks.
bool has_cycle(const DrillBlock& hole, double dwell_s);

/// "MCALL CYCLE81(10,2,0,-5)": the height before and after, the plane at which feeding begins, and the bottom, all
/// absolute. In inch programs the pitch of a tap is in inches, too.
std::string cycle_call(const CycleCall& call, const PrintGrid& grid, bool inch);

}  // namespace clearcut::post
