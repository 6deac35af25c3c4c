// Going on with a program that has been checked already.
#pragma once

#include "pipeline/resume/resume.h"

namespace clearcut::pipeline {

/// As resume_program(); `before` is what check_program() or check_program_alone() said of the program by the same options.
ResumedProgram resume_checked(CheckResult before, const ProgramQuestion& question, const Stop& stop,
                              const std::string& program, const std::string& program_name,
                              const resolve::PlanOptions& options);

}  // namespace clearcut::pipeline
