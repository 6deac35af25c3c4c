// How programs that exist are read: what options say of the machine and of the tools, for every command that takes such a program.
#pragma once

#include <string>
#include <vector>

#include "read/gcode/program/program.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// The machine's places, the subprograms beside the file, and the radii of `tools` for programs with cutter compensation; tools
/// without a number have the number that a plan gives them. Dialect, safe height and tools by hand are the caller's.
read::gcode::ReadControllerOptions reading_of(const resolve::PlanOptions& options,
                                              const std::vector<Tool>& tools, const std::string& file);

}  // namespace clearcut::pipeline
