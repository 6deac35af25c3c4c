#include "pipeline/job_options.h"

#include <algorithm>

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
    if (settings.asked.strategy && source)
      resolve::strategy_named(*settings.asked.strategy, built_in_strategies(), source->text);
  };
  check(job.plan);
  for (const read::OperationRule& rule : job.operations) check(rule.settings);
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

Toolpath read_earlier_program(const std::string& file, const Machine& machine) {
  return read::gcode::read_gcode(read_file(file), file, home_z(machine)).toolpath;
}

resolve::PlanOptions options_of_job(const read::JobFile& job) {
  check_strategies(job);
  resolve::PlanOptions options = job.whole;
  options.tool_cutting = cutting_of_tools(tools_of_job(job), job.preset);
  options.machine = job.machine;
  // Where the job says which offset the zero is at, that is no open question.
  if (job.sources.find("work-offset")) options.accept.push_back(condition_of(options.post.work_offset));
  options.sources = job.sources;
  for (const std::string& text : job.stated_keep_outs)
    options.keep_outs.push_back(resolve::parse_keep_out(text));
  for (const std::string& text : job.stated_predrilled)
    options.predrilled.push_back(resolve::parse_predrilled(text));
  options.stepover = job.plan.asked.stepover;
  if (job.after) options.earlier = read_earlier_program(job.after->string(), job.machine);
  options.post.programs_before = std::max(0, job.setup_number - 1);
  // What is said for all set-ups need not mean something to each.
  options.refuse_idle = job.setup_number == 0;
  return options;
}

}  // namespace clearcut::pipeline
