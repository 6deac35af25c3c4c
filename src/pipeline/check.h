// Checking any program against a part, whoever wrote it.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "model/control.h"
#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "model/results/margin.h"
#include "read/gcode/program/dialect.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// Checks any program text against a part. `tools` replace the part's, as in PlanOptions.
struct CheckResult {
  Part part;
  Toolpath toolpath;
  Findings findings;
  read::gcode::Dialect dialect = read::gcode::Dialect::kLinuxCnc;  ///< as which the program was read
  ControlTable control;             ///< what the control held at each move of `toolpath`
  std::optional<Toolpath> earlier;  ///< what was cut before
  std::optional<Margin> margin;     ///< absent: not asked
};
/// `dialect`: the control that will run it; absent: recognised.
/// `reference_feeds`: by number of the tool, meant at the reference where feeds follow the load and no option states one.
CheckResult check_program(const Part& part, const std::string& program, const std::string& program_name,
                          const resolve::PlanOptions& options,
                          std::optional<read::gcode::Dialect> dialect = {},
                          const std::map<int, MmPerMin>& reference_feeds = {});

/// Checks any program text as far as can be said without a part: rapids, plunges, depths and engagement in `stock`, feeds, spindle
/// and tools, limits and travel, arcs. What is left and what is gouged is not asked (Findings::without_part). Without a stock the
/// box of what is cut below `top`, mm, is taken, which is the condition "stock"; where `top` is absent, too, below Z 0 if nothing is cut
/// above it. Throws InputError for text that no control takes, and where nothing moves, no tool is given, or nothing is cut below `top`
/// in a stock that is not stated, or something above Z 0 where nobody states the top.
CheckResult check_program_alone(const std::optional<Stock>& stock, const std::string& program,
                                const std::string& program_name, const resolve::PlanOptions& options,
                                std::optional<read::gcode::Dialect> dialect = {},
                                std::optional<double> top = {},
                                const std::map<int, MmPerMin>& reference_feeds = {});

}  // namespace clearcut::pipeline
