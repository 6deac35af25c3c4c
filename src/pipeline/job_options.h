// What a job file asks of a plan, beside what its part holds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "read/gcode/program/dialect.h"
#include "read/job/job_file.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// The options of a job's [plan], [machine] and [output] with where each is said, and how its tools are driven. Its operations
/// are in its part already, see part_of_job. Reads the job's tool library and the program that has run before.
/// Throws InputError for strategies that nobody knows, also where a later rule puts them aside, and for files that cannot be read.
resolve::PlanOptions options_of_job(const read::JobFile& job);

/// Whether a machine file or a job's machine table has the key `holding`, which says how loose parts are held and so answers the
/// condition `loose-part`.
bool holds_parts(const Sources& sources);

/// What a library states for its tools, in their order; `preset` names which of several, "" the first.
std::vector<resolve::ToolCutting> cutting_of_tools(const std::vector<read::LibraryTool>& tools,
                                                   const std::string& preset);

/// Reads into `options` a program that has run before on the same stock on options.machine: its moves, what the control held meanwhile,
/// and the conditions under which it moves so. `dialect`: the control; absent, or where that does not take the program: recognised.
/// Throws InputError.
void read_earlier_program(resolve::PlanOptions& options, const std::string& file,
                          std::optional<read::gcode::Dialect> dialect = {});

}  // namespace clearcut::pipeline
