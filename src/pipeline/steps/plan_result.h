// What planning gives: the program, and all that was found out about it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/control.h"
#include "model/move.h"
#include "model/options/resolved_plan.h"
#include "model/results/findings.h"
#include "model/results/margin.h"
#include "model/results/strategy_selection.h"
#include "read/gcode/program/dialect.h"
#include "report/result.h"

namespace clearcut::pipeline {

struct PlanResult {
  Part part;             ///< as prepared: every default filled in, everything noticed in its diagnostics
  std::string program;   ///< text for the controller
  Toolpath toolpath;     ///< read back from `program`
  Toolpath planned;      ///< before it was printed
  Findings findings;     ///< of `toolpath`, with the conditions under which the control moves so
  ControlTable control;  ///< what the control holds at each move of `toolpath`
  std::vector<report::ContourLevels> contours;  ///< of each section planned by contours
  std::vector<ResolvedValue> values;            ///< every value that was decided, with its origin
  std::vector<StrategySelection> selections;    ///< strategies of each workingstep
  std::optional<Toolpath> earlier;              ///< what was cut before
  std::optional<Margin> margin;                 ///< absent: not asked
};

}  // namespace clearcut::pipeline
