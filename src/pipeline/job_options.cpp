#include "pipeline/job_options.h"

#include <algorithm>

#include "base/error.h"
#include "base/files/file.h"
#include "pipeline/selection/strategies.h"
#include "read/gcode/gcode.h"
#include "resolve/names.h"

namespace clearcut::pipeline {
namespace {

/// Also those that a later rule puts aside: a name that is unknown is never meant.
void check_strategies(const read::JobFile& job) {
  const auto check = [](const read::CutSettings& settings) {
    const Source* source = settings.sources.find("strategy");
    if (settings.strategy && source)
      resolve::strategy_named(*settings.strategy, built_in_strategies(), source->text);
  };
  check(job.plan);
  for (const read::OperationRule& rule : job.operations) check(rule.settings);
}

/// As the control that is named; where that does not take it, as the one for which it was written.
read::gcode::Program read_as_its_control(const std::string& file, const Machine& machine,
                                         std::optional<read::gcode::Dialect> dialect) {
  read::gcode::ReadControllerOptions reading;
  reading.home_z = home_z(machine);
  reading.places = machine.places;
  const std::string text = read_file(file);
  try {
    reading.dialect = dialect;
    return read::gcode::read_gcode(text, file, reading);
  } catch (const InputError&) {
    if (!dialect) throw;
    reading.dialect.reset();
    return read::gcode::read_gcode(text, file, reading);
  }
}

PostOptions post_of(const read::JobOutput& output) {
  PostOptions post;
  post.dialect = output.post.value_or("linuxcnc");
  post.inch = output.inch.value_or(false);
  post.work_offset = output.work_offset.value_or(WorkOffset{});
  post.end = output.end_position.value_or(EndPosition{});
  post.decimals = output.decimals;
  post.arcs = output.arcs.value_or(true);
  post.tool_changer = output.tool_change.value_or(true);
  post.length_offset = output.length_offset.value_or(true);
  post.exact_stop = output.exact_stop.value_or(false);
  post.program_number = output.program_number;
  post.block_numbers = output.block_numbers.value_or(false);
  post.optional_stop = output.optional_stop.value_or(false);
  if (output.spindle_wait) post.spindle_wait = Seconds::of(*output.spindle_wait);
  return post;
}

}  // namespace

std::vector<resolve::ToolCutting> cutting_of_tools(const std::vector<read::LibraryTool>& tools,
                                                   const std::string& preset) {
  std::vector<resolve::ToolCutting> cutting;
  for (const read::LibraryTool& tool : tools) {
    const read::CuttingPreset* found = preset_of(tool, preset);
    cutting.push_back(found ? resolve::ToolCutting{true, found->cutting, found->stepdown, found->stepover}
                            : resolve::ToolCutting{});
  }
  return cutting;
}

void read_earlier_program(resolve::PlanOptions& options, const std::string& file,
                          std::optional<read::gcode::Dialect> dialect) {
  read::gcode::Program program = read_as_its_control(file, options.machine, dialect);
  options.earlier = std::move(program.toolpath);
  options.earlier_state = {std::move(program.control), std::move(program.conditions), {}};
  for (Condition& one : options.earlier_state.conditions) {
    one.text = "in " + file + ", which has run before: " + one.text;
    one.line = 0;  // of another program
  }
}

resolve::PlanOptions options_of_job(const read::JobFile& job) {
  check_strategies(job);
  resolve::PlanOptions options;
  options.tool_cutting = cutting_of_tools(tools_of_job(job), job.preset);
  options.machine = job.machine;
  options.accept = job.accept;
  // Where the job says which offset the zero is at, that is no open question.
  if (job.output.work_offset) options.accept.push_back(condition_of(*job.output.work_offset));
  options.sources = job.sources;
  options.stepover = job.plan.stepover;
  options.engagement_deg = job.engagement_deg;
  options.shop = job.shop;
  options.tabs = job.tabs;
  options.post = post_of(job.output);
  if (job.after)
    read_earlier_program(options, job.after->string(),
                         job.output.post ? read::gcode::dialect_named(*job.output.post) : std::nullopt);
  options.post.programs_before = std::max(0, job.setup_number - 1);
  options.angle_deg = job.angle_deg;
  options.outside_in = job.order == ContourOrder::kOutsideIn;
  options.start = job.start;
  options.objective = job.objective.value_or("time");
  options.time_s = job.time_s;
  options.seed = job.seed.value_or(1);
  return options;
}

}  // namespace clearcut::pipeline
