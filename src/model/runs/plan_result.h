// A planned, posted and certified program.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/control.h"
#include "model/move.h"
#include "model/options/resolved_plan.h"
#include "model/part.h"
#include "model/results/contour_levels.h"
#include "model/results/copies_made.h"
#include "model/results/findings.h"
#include "model/results/margin.h"
#include "model/results/strategy_selection.h"

namespace clearcut::inline model {

struct PlanResult {
  Part part;             ///< as prepared: every default filled in, everything noticed in its diagnostics
  std::string program;   ///< text for the controller
  Toolpath toolpath;     ///< read back from `program`
  Toolpath planned;      ///< toolpath before printing
  Findings findings;     ///< findings on `toolpath`, with the conditions for these motions of the control
  ControlTable control;  ///< state of the control at each move of `toolpath`
  std::vector<ContourLevels> contours;        ///< contours of each section planned by contours
  std::vector<ResolvedValue> values;          ///< every decided value, with its origin
  std::vector<StrategySelection> selections;  ///< strategies of each workingstep
  std::optional<Toolpath> earlier;            ///< earlier cuts
  /// mm; of each section of `planned` the rounding of corners that the program states; empty: the usual one of all.
  std::vector<double> corner_tolerances;
  std::optional<Margin> margin;      ///< absent: not asked
  std::optional<CopiesMade> copies;  ///< absent: one part
};

}  // namespace clearcut::inline model
