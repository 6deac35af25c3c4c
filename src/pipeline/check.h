// Judging any program against a part, whoever wrote it.
#pragma once

#include <optional>
#include <string>

#include "model/control.h"
#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "read/gcode/dialect.h"
#include "resolve/plan_options.h"

namespace clearcut::pipeline {

/// Judges any program text against a part. `tools` replace the part's, as in PlanOptions.
struct CheckResult {
  Part part;
  Toolpath toolpath;
  Findings findings;
  read::gcode::Dialect dialect = read::gcode::Dialect::kLinuxCnc;  ///< as which the program was read
  ControlTable control;  ///< what the control held at each move of `toolpath`
};
/// `dialect`: the control that will run it; absent: recognised.
CheckResult check_program(const Part& part, const std::string& program, const std::string& program_name,
                          const resolve::PlanOptions& options,
                          std::optional<read::gcode::Dialect> dialect = {});

}  // namespace clearcut::pipeline
