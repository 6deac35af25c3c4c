// Going on with a program that was stopped, or has been checked already: the rest of its text behind lines that bring
// the control and the cutter back.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/program_feeds.h"

namespace clearcut::pipeline {

/// Where a program was stopped: one of the two.
struct Stop {
  std::optional<int> line;  ///< the first that is run again
  std::optional<std::array<double, 3>>
      place;  ///< mm: where the tip stood; the move that passes there is run again as a whole
};

struct ResumedProgram {
  std::string program;
  int line = 0;          ///< of the program as it was, with which it goes on
  int new_lines = 0;     ///< in front of that line
  int passes = 1;        ///< moves that pass the place; the first is taken
  double beside_mm = 0;  ///< how far the place lies beside the path
  Place begin;           ///< where the old text goes on
  int tool = 0;          ///< with which it does
  CheckResult before;    ///< of the program as it was
  CheckResult after;     ///< of `program`, with what was cut before `line` taken away
};

/// `program` from `stop` on, its text unchanged.
///
/// Throws InputError for Sinumerik, for a line at which the program cannot be begun anew, with the nearest that serves, for a
/// place that no feed move passes within 1 mm, and where the lines in front do not bring the control into its state or the rest does
/// not move as before.
ResumedProgram resume_program(const ProgramQuestion& question, const Stop& stop, const std::string& program,
                              const std::string& program_name, const resolve::PlanOptions& options);

/// As resume_program(); `before` is what check_program() or check_program_alone() said of the program by the same options.
ResumedProgram resume_checked(CheckResult before, const ProgramQuestion& question, const Stop& stop,
                              const std::string& program, const std::string& program_name,
                              const resolve::PlanOptions& options);

}  // namespace clearcut::pipeline
