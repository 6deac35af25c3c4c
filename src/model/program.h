// A program as a control reads it.
#pragma once

#include <vector>

#include "base/diagnostics.h"
#include "model/control.h"
#include "model/dialect.h"
#include "model/move.h"

namespace clearcut::inline model {

/// Moves of a program, what the control does besides, and what is to be said of its text.
struct Program {
  Toolpath toolpath;
  ControlTable
      control;  ///< tool length, spindle, path control at each move; dwells and tool changes between them
  Diagnostics
      diagnostics;  ///< words that were ignored or assumed without moving anything, each with its line
  std::vector<Condition>
      conditions;  ///< what must hold at the machine for `toolpath` to be what it does; one a name
  std::vector<int> compensated_tools;    ///< T words under cutter compensation, ascending
  Dialect dialect = Dialect::kLinuxCnc;  ///< as which it was read
  bool dialect_stated = false;           ///< by the options; else recognised
  bool ended = false;                    ///< an end word was seen; Marlin has none and ends with the text
};

}  // namespace clearcut::inline model
