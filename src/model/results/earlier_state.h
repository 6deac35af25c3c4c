// The state of programs that ran before: control, conditions, faults. Their cuts are in the toolpath.
#pragma once

#include <vector>

#include "model/control.h"
#include "model/results/findings.h"

namespace clearcut::inline model {

/// The conditions and faults of earlier programs. A verdict that rests on their cuts holds only where these conditions held, and is FAULTY
/// where there are such faults.
struct EarlierState {
  ControlTable control;  ///< what the control held at each of their moves; no spans: it was checked elsewhere
  std::vector<Condition> conditions;  ///< what must have held at the machine; the text names the program
  std::vector<Fault> faults;  ///< what was found wrong with them elsewhere; the text names the program
};

}  // namespace clearcut::inline model
