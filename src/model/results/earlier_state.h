// The state after earlier programs: control, conditions, faults. Their cuts are in the toolpath.
#pragma once

#include <vector>

#include "model/control.h"
#include "model/results/findings.h"

namespace clearcut::inline model {

/// The conditions and faults of earlier programs. A verdict relying on their cuts is valid only if these conditions
/// were met, and is FAULTY if there are such faults.
struct EarlierState {
  /// State of the control at each of their moves; without spans: it was checked elsewhere.
  ControlTable control;
  /// Facts that must have been true at the machine; the text names the program.
  std::vector<Condition> conditions;
  std::vector<Fault> faults;  ///< faults found elsewhere in these programs; the text names the program
};

}  // namespace clearcut::inline model
