// Job files: part, stock, tools, machine and operations in one TOML; see docs/input.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "model/machine.h"
#include "model/options/origin.h"
#include "model/part.h"
#include "options/job_file.h"
#include "options/plan_options.h"
#include "options/read_options.h"
#include "options/row.h"
#include "read/common/moved_part.h"
#include "read/tools/tool_library.h"

namespace clearcut::read {

/// Throws  InputError "file:line: ..." for bad TOML, unknown keys (with the nearest known one) and
///         impossible values.
JobFile read_job_text(std::string_view text, const std::string& file_name);
JobFile read_job(const std::filesystem::path& file);

/// The part of a job: its file read, stock and tools set, operations chosen. All of job.plan is in the operations
/// afterwards, with their places as sources; machine, output and the planner's values are left to the caller. `over`:
/// options with precedence over the job's own (command line). Throws as read_part and read_tool_library, and if a
/// tool number or a feature name has no match.
Part part_of_job(const JobFile& job, const ReadOptions& over);

/// The same; afterwards `sources` contains the sources of all values stated by the job or its tool library,
/// `published` the job's choices of published methods.
Part part_of_job(const JobFile& job, const ReadOptions& over, StepSources& sources, StepChoices& published);
/// The job's own tools, then the used ones of its library: the tools of its part, in their order.
std::vector<LibraryTool> tools_of_job(const JobFile& job);

/// A commented job for `part`, read from `part_file`: valid without changes, with every key and its default; `stated`
/// options are written as keys, so that a plan of the job equals the plan with those options.
std::string job_text(const Part& part, const std::string& part_file, const StatedOptions& stated = {});

}  // namespace clearcut::read
