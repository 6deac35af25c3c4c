// Checks any program against a part, regardless of its author.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "model/control.h"
#include "model/move.h"
#include "model/part.h"
#include "model/runs/check_result.h"
#include "read/gcode/program/dialect.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

// The check of a program against a part, and without one; include/clearcut/verify.h promises both functions and says more of them.
CheckResult check_program(const Part& part, const std::string& program, const std::string& program_name,
                          const PlanOptions& options, std::optional<Dialect> dialect = {},
                          const std::map<int, MmPerMin>& reference_feeds = {});

CheckResult check_program_alone(const std::optional<Stock>& stock, const std::string& program,
                                const std::string& program_name, const PlanOptions& options,
                                std::optional<Dialect> dialect = {}, std::optional<double> top = {},
                                const std::map<int, MmPerMin>& reference_feeds = {});

/// The first part of the same program, as it ran.
struct FirstPart {
  Toolpath toolpath;
  EarlierState state;
};

/// As check_program() and check_program_alone(), where `first` has run before. Unlike a program before (PlanOptions::earlier) it takes
/// no tool from what is still to be done.
CheckResult check_rest(const Part& part, const FirstPart& first, const std::string& program,
                       const std::string& program_name, const PlanOptions& options,
                       std::optional<Dialect> dialect);
CheckResult check_rest_alone(const Stock& stock, const FirstPart& first, const std::string& program,
                             const std::string& program_name, const PlanOptions& options,
                             std::optional<Dialect> dialect);

}  // namespace clearcut::pipeline
