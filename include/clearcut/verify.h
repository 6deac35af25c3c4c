// Checking programs, whoever wrote them: read_program() gives the moves, check_program() what they do to a part.
#pragma once

#include "clearcut/part.h"
#include "model/move.h"
#include "model/results/findings.h"
#include "pipeline/check.h"
#include "pipeline/check_text.h"
#include "pipeline/program_feeds.h"
#include "pipeline/result_figures.h"
#include "pipeline/resume/resume.h"
#include "read/gcode/gcode.h"
#include "resolve/values/plan_options.h"

namespace clearcut {

using pipeline::check_program;
using pipeline::check_program_alone;
using pipeline::check_text;
using pipeline::CheckResult;
using pipeline::feeds_of_program;
using pipeline::figures_of_moves;
using pipeline::margin_line;
using pipeline::MoveFigures;
using pipeline::ProgramFeeds;
using pipeline::ProgramQuestion;
using pipeline::question_options;
using pipeline::resume_program;
using pipeline::ResumedProgram;
using pipeline::Stop;
using pipeline::times_of_moves;

using Program = read::gcode::Program;

/// The moves of G-code or Klartext, line by line. `file_name` stands in messages; `home_z`, mm, is the height of places that
/// a program names without stating them, see home_z(Machine). Throws InputError "file:line: ..." for what cannot be understood.
inline Program read_program(std::string_view text, const std::string& file_name,
                            double home_z = kUsualHomeZ) {
  return read::gcode::read_gcode(text, file_name, home_z);
}

}  // namespace clearcut
