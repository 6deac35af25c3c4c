// Functions of include/clearcut/verify.h, by calls of the stages.
#include <clearcut/verify.h>

#include <utility>

#include "pipeline/check.h"
#include "pipeline/program_feeds.h"
#include "pipeline/result_figures.h"
#include "pipeline/resume/resume.h"
#include "read/gcode/gcode.h"

namespace clearcut {

CheckResult check_program(const Part& part, const std::string& program, const std::string& program_name,
                          const PlanOptions& options, std::optional<Dialect> dialect,
                          const std::map<int, MmPerMin>& reference_feeds) {
  return pipeline::check_program(part, program, program_name, options, dialect, reference_feeds);
}

CheckResult check_program_alone(const std::optional<Stock>& stock, const std::string& program,
                                const std::string& program_name, const PlanOptions& options,
                                std::optional<Dialect> dialect, std::optional<double> top,
                                const std::map<int, MmPerMin>& reference_feeds) {
  return pipeline::check_program_alone(stock, program, program_name, options, dialect, top, reference_feeds);
}

ProgramFeeds feeds_of_program(const ProgramQuestion& question, const std::string& program,
                              const std::string& program_name, const PlanOptions& options) {
  return pipeline::feeds_of_program(question, program, program_name, options);
}

std::vector<MoveFigures> figures_of_moves(const Part& part, const Toolpath& toolpath,
                                          const ControlTable& control, const PlanOptions& options) {
  return pipeline::figures_of_moves(part, toolpath, control, options);
}

std::string margin_line(const Margin& margin) {
  return pipeline::margin_line(margin);
}

ResumedProgram resume_program(const ProgramQuestion& question, const Stop& stop, const std::string& program,
                              const std::string& program_name, const PlanOptions& options) {
  return pipeline::resume_program(question, stop, program, program_name, options);
}

std::vector<double> times_of_moves(const Part& part, const Toolpath& toolpath, const ControlTable& control,
                                   const PlanOptions& options) {
  return pipeline::times_of_moves(part, toolpath, control, options);
}

Program read_program(std::string_view text, const std::string& file_name, double home_z) {
  return read::gcode::read_gcode(text, file_name, home_z);
}

}  // namespace clearcut
