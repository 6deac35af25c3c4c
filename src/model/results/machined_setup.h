// Set-ups of one workpiece that are machined, and the stock that they leave to later ones.
#pragma once

#include <string>
#include <vector>

#include "model/control.h"
#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "model/setup_place.h"

namespace clearcut::inline model {

/// A machined set-up: its part with the tools of its program, and the moves of that program as read back.
struct MachinedSetup {
  Part part;
  Toolpath toolpath;
  SetupPlace place;
  /// Conditions and faults of its program not reported to the user elsewhere.
  std::vector<Condition> conditions = {};
  std::vector<Fault> faults = {};
};

/// Stock left by earlier set-ups, in the coordinates of a later one.
struct CarriedStock {
  Stock block;       ///< without layers faced off completely
  Toolpath sweeps;   ///< moves of cylinders that have removed the missing material
  std::string told;  ///< description of the carried and omitted cuts, for people
  /// "floors-meet": see meeting_floors(); and conditions of the earlier programs.
  std::vector<Condition> conditions;
  std::vector<Fault> faults;  ///< faults of the earlier programs
};

/// One of several set-ups of a workpiece, with what is planned for it.
struct WrittenSetup {
  Part part;  ///< in the coordinates of the set-up
  Toolpath toolpath;
  SetupPlace place;  ///< of the set-up
};

}  // namespace clearcut::inline model
