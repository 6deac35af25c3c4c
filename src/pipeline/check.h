// Checks any program against a part, regardless of its author.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "model/control.h"
#include "model/move.h"
#include "model/part.h"
#include "model/results/copies_made.h"
#include "model/results/findings.h"
#include "model/results/margin.h"
#include "model/runs/check_result.h"
#include "read/gcode/program/dialect.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// `dialect`: the control that will run the program; absent: recognised. `reference_feeds`: feeds at the reference by
/// tool number, used if feeds follow the load and no option states one.
CheckResult check_program(const Part& part, const std::string& program, const std::string& program_name,
                          const PlanOptions& options, std::optional<Dialect> dialect = {},
                          const std::map<int, MmPerMin>& reference_feeds = {});

/// Checks any program text as far as possible without a part: rapids, plunges, depths and engagement in `stock`,
/// feeds, spindle and tools, limits and travel, arcs. Uncut material and gouges are not examined
/// (Findings::without_part). Without a stock the box of all cuts below `top`, mm, is assumed, with the condition
/// "stock"; if `top` is absent, too, below Z 0, provided no cut is above. Throws InputError for text that no control
/// accepts, and if nothing moves, no tool is given, no cut is below `top` without a stated stock, or some cut is
/// above Z 0 without a stated top.
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
