// Which of several cutters, or which sequence of them, cuts a part soonest (CPO-rho section 4).
//
//   paper   here                        unit     meaning
//   R_i     Tool::radius()              mm
//   Z_i     Tool::teeth
//   f_z,i   ToolSpeeds::feeds_per_tooth mm
//   V_c     ToolSpeeds::cutting_speed   m/min
//   n       CuttingData::spindle_rpm    rpm      1000 V_c / (pi D)
//   V_f     CuttingData::feed           mm/min   f_z Z n
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/compare.h"
#include "report/words/text_table.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// How cutters are driven; what is absent comes from the part or the defaults of prepare().
struct ToolSpeeds {
  std::optional<double> cutting_speed;
  std::vector<double> feeds_per_tooth;  ///< of each tool in the order given; the last serves the rest
  double tool_change_s = 10;            ///< between the tools of a sequence
};

/// Spindle and feed of a tool with `feed_per_tooth`. Units and formulas above.
CuttingData driven(const Tool& tool, double cutting_speed, double feed_per_tooth);

/// One cutter, alone on the whole part.
struct ToolRun {
  Tool tool;
  double spindle_rpm = 0;
  double feed_mm_per_min = 0;
  bool fits = false;
  std::string refusal;  ///< why it does not
  bool clean = false;
  double feed_mm = 0;
  double time_s = 0;           ///< kinematic
  double published_s = 0;      ///< CPO-rho eq. 9
  double unreachable_mm2 = 0;  ///< corners that it cannot reach
};

/// Every tool of the options (else of the part) alone on every feature, smallest first. Throws InputError without tools
/// and for speeds that are not above 0.
/// Cost one plan each.
std::vector<ToolRun> run_tools(const Part& part, const ToolSpeeds& speeds,
                               const resolve::PlanOptions& options, const CountCallback& count = {});

/// The fastest that is certified clean; null where none is.
const ToolRun* fastest_clean(const std::vector<ToolRun>& runs);

/// Cutters one after the other, largest first.
struct ToolSequence {
  std::vector<Tool> tools;
  double time_s = 0;  ///< kinematic, with the changes between them
};

/// The fastest sequence that leaves no more than the smallest cutter alone would; none where that cannot be cut clean.
/// Each one cuts what larger ones cannot reach, which depends on the one before it alone: a shortest way over pairs.
/// Cost a plan for every two tools.
std::optional<ToolSequence> fastest_sequence(const Part& part, const ToolSpeeds& speeds,
                                             const resolve::PlanOptions& options);

/// Every cutter alone, and the fastest sequence of them.
struct ToolComparison {
  std::vector<ToolRun> runs;
  std::optional<ToolSequence> sequence;
};

/// Throws InputError where no cutter can be used. `count` hears of the plans of cutters alone and of pairs.
ToolComparison compare_tools(const Part& part, const ToolSpeeds& speeds, const resolve::PlanOptions& options,
                             const CountCallback& count = {});

/// The table, with the fastest clean cutter marked and the fastest sequence under it.
report::TextTable tool_table(const Part& part, const ToolSpeeds& speeds, const ToolComparison& comparison);

}  // namespace clearcut::pipeline
