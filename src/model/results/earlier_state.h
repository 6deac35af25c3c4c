// What is known of programs that ran before, besides what they cut.
#pragma once

#include <vector>

#include "model/control.h"
#include "model/results/findings.h"

namespace clearcut::inline model {

/// What they cut is as it was read only where all of this is so: it belongs to the question that rests on their cuts.
struct EarlierState {
  ControlTable control;  ///< what the control held at each of their moves; no spans: it was checked elsewhere
  std::vector<Condition> conditions;  ///< what must have held at the machine; the text names the program
  std::vector<Fault> faults;  ///< what was found wrong with them elsewhere; the text names the program
};

}  // namespace clearcut::inline model
