// Checking a program that goes on with another: which tools make what is decided as for the whole.
#pragma once

#include "model/results/earlier_state.h"
#include "pipeline/check.h"

namespace clearcut::pipeline {

/// The first part of the same program, as it ran.
struct FirstPart {
  Toolpath toolpath;
  EarlierState state;
};

/// As check_program() and check_program_alone(), where `first` has run before. Unlike a program before (PlanOptions::earlier) it takes
/// no tool from what is still to be done.
CheckResult check_rest(const Part& part, const FirstPart& first, const std::string& program,
                       const std::string& program_name, const resolve::PlanOptions& options,
                       std::optional<read::gcode::Dialect> dialect);
CheckResult check_rest_alone(const Stock& stock, const FirstPart& first, const std::string& program,
                             const std::string& program_name, const resolve::PlanOptions& options,
                             std::optional<read::gcode::Dialect> dialect);

}  // namespace clearcut::pipeline
