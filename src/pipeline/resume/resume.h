// Going on with a program that was stopped, or has been checked already: the rest of its text behind lines that bring
// the control and the cutter back.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/program_feeds.h"

namespace clearcut::pipeline {

/// `program` from `stop` on, its text unchanged.
///
/// Throws InputError for Sinumerik, for a line at which the program cannot be begun anew, with the nearest that serves, for a
/// place that no feed move passes within 1 mm, and where the lines in front do not bring the control into its state or the rest does
/// not move as before.
ResumedProgram resume_program(const ProgramQuestion& question, const Stop& stop, const std::string& program,
                              const std::string& program_name, const PlanOptions& options);

/// As resume_program(); `before` is what check_program() or check_program_alone() said of the program by the same options.
ResumedProgram resume_checked(CheckResult before, const ProgramQuestion& question, const Stop& stop,
                              const std::string& program, const std::string& program_name,
                              const PlanOptions& options);

}  // namespace clearcut::pipeline
