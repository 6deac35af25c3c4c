// One part planned by several strategies or cutters.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/options/tour_options.h"
#include "model/results/findings.h"
#include "model/results/published_time.h"
#include "model/tool.h"

namespace clearcut::inline model {

/// One strategy on the whole part.
struct StrategyRun {
  std::string strategy;
  std::optional<Figures> figures;  ///< none where it cannot plan the part
  std::string refusal;             ///< and why
  PublishedTime published = {};    ///< CPO-rho eq. 9
};

/// One cutter, used for the whole part.
struct ToolRun {
  Tool tool;
  double spindle_rpm = 0;
  double feed_mm_per_min = 0;
  bool fits = false;
  std::string refusal;  ///< reason for a refusal
  bool clean = false;
  double feed_mm = 0;
  double time_s = 0;           ///< kinematic
  double published_s = 0;      ///< CPO-rho eq. 9
  double unreachable_mm2 = 0;  ///< area of corners out of its reach
  Figures figures;             ///< all of its certificate
};

/// Cutters one after the other, largest first.
struct ToolSequence {
  std::vector<Tool> tools;
  double time_s = 0;  ///< kinematic, with the changes between them
};

/// Every cutter by itself, and the fastest sequence of them.
struct ToolComparison {
  std::vector<ToolRun> runs;
  std::optional<ToolSequence> sequence;  ///< fastest; none if the objective is load
  Objective objective;                   ///< by which the best cutter is chosen, if it is load; else by time
};

}  // namespace clearcut::inline model
