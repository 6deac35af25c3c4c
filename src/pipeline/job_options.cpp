#include "pipeline/job_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "base/error.h"
#include "base/file.h"
#include "options/idle.h"
#include "options/row.h"
#include "pipeline/program_feeds.h"
#include "pipeline/selection/strategies.h"
#include "pipeline/stated_machine.h"
#include "post/post.h"
#include "read/gcode/gcode.h"
#include "read/job/read_part.h"
#include "resolve/values/names.h"

namespace clearcut::pipeline {
namespace {

/// Also strategies overridden by a later rule: an unknown name is never intended.
void check_strategies(const JobFile& job) {
  const auto check = [](const CutSettings& settings) {
    const Source* source = settings.sources.find("strategy");
    if (settings.asked.strategy && source)
      resolve::strategy_named(*settings.asked.strategy, built_in_strategies(), source->text);
  };
  check(job.plan);
  for (const OperationRule& rule : job.operations) check(rule.settings);
}

/// As the control that is named; where that does not take it, as the one for which it was written.
Program read_as_its_control(const std::string& file, const PlanOptions& options,
                            std::optional<Dialect> dialect) {
  read::gcode::ReadControllerOptions reading = reading_of(options, options.tools, file);
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

}  // namespace

std::vector<ToolCutting> cutting_of_tools(const std::vector<LibraryTool>& tools, const std::string& preset) {
  std::vector<ToolCutting> cutting;
  for (const LibraryTool& tool : tools) {
    const CuttingPreset* found = read::preset_of(tool, preset);
    cutting.push_back(found ? ToolCutting{true, found->cutting, found->stepdown, found->stepover}
                            : ToolCutting{});
  }
  return cutting;
}

void read_earlier_program(PlanOptions& options, const std::string& file, std::optional<Dialect> dialect) {
  Program program = read_as_its_control(file, options, dialect);
  options.earlier = std::move(program.toolpath);
  options.earlier_state = {std::move(program.control), std::move(program.conditions), {}};
  for (Condition& one : options.earlier_state.conditions) {
    one.text = "in " + file + ", which has run before: " + one.text;
    one.line = 0;  // a line of another program
  }
}

PlanOptions options_of_job(const JobFile& job) {
  check_strategies(job);
  PlanOptions options = job.whole;
  options.tool_cutting = cutting_of_tools(read::tools_of_job(job), job.preset);
  options.machine = job.machine;
  // If the job states the offset of the zero, this condition is met.
  if (job.sources.find("work-offset")) options.accept.push_back(condition_of(options.post.work_offset));
  accept_what_is_held(job.sources, options);
  options.sources = job.sources;
  resolve::add_places(job.stated_keep_outs, job.stated_predrilled, options);
  options.stepover = job.plan.asked.stepover;
  if (job.after)
    read_earlier_program(options, job.after->string(), read::gcode::dialect_named(options.post.dialect));
  options.post.programs_before = std::max(0, job.setup_number - 1);
  // Options for all set-ups need not have an effect in each.
  options.refuse_idle = job.setup_number == 0;
  return options;
}

namespace {

/// The name under which the origin of a row's value is stored: for switches of defaults that are on, the name of the
/// key.
std::string source_name(const Row& row) {
  std::string name = row.key_is_opposite ? row.job_key() : row.name;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

/// "--tabs", "job.toml:12: tabs".
std::string place_of(const Row& row, const Source& source) {
  return source.origin == Origin::kJobFile ? source.text + ": " + row.job_key() : source.text;
}

/// "2,5": outlines of one drawing, by their numbers.
bool is_by_number(const LayerRule& rule) {
  return !rule.pattern.empty() && rule.pattern.find_first_not_of("0123456789, ") == std::string::npos;
}

/// The job of the first part for another file: without what it says of places and of single features.
JobFile for_another_part(JobFile job, const std::string& file) {
  job.part_file = file;
  std::erase_if(job.operations, [](const OperationRule& rule) { return rule.feature != "*"; });
  std::erase_if(job.read.layer_rules, is_by_number);
  job.sequence.clear();
  job.keep_outs.clear();
  job.predrilled.clear();
  if (!job.stock) return job;
  job.stock->x.reset();
  job.stock->y.reset();
  return job;
}

bool is_same_machine(const Machine& a, const Machine& b) {
  const auto values = [](const Machine& m) {
    return std::tie(m.name, m.rapid, m.acceleration, m.junction_deviation, m.planner, m.axis_rapid,
                    m.axis_acceleration, m.jerk, m.speed_jump, m.arc_tolerance, m.max_spindle_rpm,
                    m.min_spindle_rpm, m.spindle_power_w, m.spindle_torque_nm, m.max_feed, m.cutting_force_n,
                    m.stiffness, m.program_number, m.spindle_wait_s, m.tool_change_s, m.path_tolerance,
                    m.travel);
  };
  const auto places = [](const MachinePlaces& p) {
    return std::tie(p.start, p.origins, p.stated_origins, p.reference, p.second_reference);
  };
  return values(a) == values(b) && a.places.has_value() == b.places.has_value() &&
         (!a.places || places(*a.places) == places(*b.places));
}

/// Throws InputError for what a job of a further part states of the whole plan otherwise than `options`.
void refuse_other_sheet(const JobFile& job, const PlanOptions& options) {
  if (!job.setups.empty())
    throw InputError(job.file, "has several set-ups; parts that lie on one sheet have one");
  if (job.after || job.stock_from)
    throw InputError(job.file, "states what is left of its block; parts of one sheet begin with a whole one");
  if (!job.stated_keep_outs.empty() || !job.keep_outs.empty())
    throw InputError(job.file, "states clamps, which are those of the sheet; state them with the first part");
  if (!job.stated_predrilled.empty())
    throw InputError(job.file, "states predrilled holes in its [plan]; write them as [[predrilled]]");
  if (!is_same_machine(job.machine, Machine{}) && !is_same_machine(job.machine, options.machine))
    throw InputError(job.file, "states another [machine] than the first part; a sheet is cut on one");
  const Asked sheet{options, {}}, own{job.whole, {}};
  for (const Row& row : rows()) {
    const Source* const source = job.sources.find(source_name(row));
    if (!source || row.is_of_operations || !row.field.is_of_plan || row.group == Group::kMachine) continue;
    if (row.field.get(sheet, row.names) != row.field.get(own, row.names))
      throw InputError(source->text + ": " + row.job_key(),
                       "is of the whole sheet, for which the first part states another value or none");
  }
}

NestedPart read_nested_part(const NestedFile& named, const PlanOptions& options,
                            const std::optional<JobFile>& of_first, ReadOptions over) {
  NestedPart nested;
  nested.count = named.count;
  std::erase_if(over.layer_rules, is_by_number);
  const bool has_own_job = read::is_job_file(named.file);
  if (!has_own_job && !of_first) {
    nested.part = read::read_part(named.file, over);
    return nested;
  }
  const JobFile job = has_own_job ? read::read_job(named.file) : for_another_part(*of_first, named.file);
  if (has_own_job) refuse_other_sheet(job, options);
  nested.part = read::part_of_job(job, over, nested.step_sources, nested.step_published);
  nested.tool_cutting = cutting_of_tools(read::tools_of_job(job), job.preset);
  return nested;
}

/// Whether the value is the one that requests no effect: 0 tabs, a lift of 0 mm.
bool asks_nothing(const Row& row, const Asked& asked) {
  if (!row.neutral || !row.field.get) return false;
  const auto value = row.field.get(asked, row.names);
  return value && std::get<double>(*value) == *row.neutral;
}

/// Compares the written program with the program written without the option.
std::string idle_in_program(const Row& row, const PlanResult& result, const Toolpath& planned,
                            const ResolvedPlan& plan, const Asked& asked) {
  static const Asked kNothing;
  const auto usual = row.field.get(kNothing, row.names);
  Asked other{asked.plan, {}};
  other.plan.post = plan.post;
  if (usual)
    row.field.set(other, *usual, row.names);
  else if (row.name == "decimals")
    other.plan.post.decimals.reset();
  else if (row.name == "corner-tolerance")
    other.plan.post.corner_tolerance.reset();
  else if (row.name == "program-number")
    other.plan.post.program_number.reset();
  else
    return "";
  PostOptions own = plan.post;
  if (row.name == "corner-tolerance") own.corner_tolerances = result.corner_tolerances;
  const bool is_same = post::write_program(planned, result.part, own) ==
                       post::write_program(planned, result.part, other.plan.post);
  if (!is_same) return "";
  std::string reason = "the program for " + own.dialect + " is the same without it";
  if (row.name == "corner-tolerance" && !result.corner_tolerances.empty())
    reason += ", as rounding its corners by more saves no time or leaves too much";
  return reason;
}

bool is_stated(const Source* source) {
  return source && (source->origin == Origin::kUser || source->origin == Origin::kJobFile);
}

}  // namespace

std::vector<NestedPart> read_nested_parts(const PlanOptions& options, const std::optional<JobFile>& of_first,
                                          const ReadOptions& over) {
  std::vector<NestedPart> parts;
  for (const std::string& text : options.copies.with) {
    const auto named = nested_file(text);
    if (!named) throw InputError("--nest-with " + text, "needs a file, or a file and a number of parts");
    parts.push_back(read_nested_part(*named, options, of_first, over));
  }
  return parts;
}

namespace {

/// Asks `reason_of` about each row whose value the user or a job states and which requests something: those with a reason.
template <typename ReasonOf>
std::vector<IdleOption> stated_without_effect(const Asked& asked, const ReasonOf& reason_of) {
  std::vector<IdleOption> idle;
  for (const Row& row : rows()) {
    const Source* source = asked.plan.sources.find(source_name(row));
    if (!is_stated(source) || asks_nothing(row, asked)) continue;
    const std::string reason = reason_of(row);
    if (!reason.empty()) idle.push_back({place_of(row, *source), reason});
  }
  return idle;
}

void refuse_first(const std::vector<IdleOption>& idle) {
  if (!idle.empty()) throw InputError(idle.front().place, idle.front().reason);
}

std::string idle(const std::string& reason) {
  return reason.empty() ? "" : "has no effect: " + reason + "; leave it out";
}

/// What is not cleared is cut along its outline or axis: no other strategy than contour has an effect on it.
unsigned works_served(const Row& row, const ResolvedStep& step) {
  const bool along_outlines = !step.strategy || step.strategy->name == "contour";
  return row.name == "strategy" && !along_outlines ? kClearing | kBoring : row.effect.works;
}

/// Throws InputError for a key of a job's operation that serves none of the workingsteps that the operation became.
void refuse_keys_for_others(const ResolvedPlan& plan, const PlanOptions& asked) {
  struct Stated {
    bool serves = false;
    unsigned served = kAllWorks;
    std::string feature;
  };
  std::map<std::string, Stated> by_place;
  for (const ResolvedValue& value : plan.values) {
    const Row* row = row_named(value.name);
    if (value.step < 0 || value.source.origin != Origin::kJobFile || !row || !row->is_of_operations) continue;
    const Source* of_whole = asked.sources.find(source_name(*row));
    if (of_whole && of_whole->text == value.source.text) continue;
    const auto i = static_cast<std::size_t>(value.step);
    const Workingstep& step = plan.part.workplan[i];
    Stated& stated = by_place[place_of(*row, value.source)];
    if (stated.feature.empty()) stated.feature = feature_of(plan.part, step).name;
    stated.served = works_served(*row, plan.steps[i]);
    stated.serves = stated.serves || (stated.served & work_of(plan.part, step)) != 0;
  }
  for (const auto& [place, stated] : by_place)
    if (!stated.serves)
      throw InputError(place, fmt::format("has no effect on {}: it serves {}; leave it out", stated.feature,
                                          names_of_works(stated.served)));
}

}  // namespace

namespace {

std::vector<IdleOption> options_for_others(const ResolvedPlan& plan, const PlanOptions& asked) {
  const InputKinds input = input_kind_of(plan.part);
  const unsigned works = works_of(plan);
  return stated_without_effect({asked, {}}, [&](const Row& row) {
    const std::string reason = idle_on_input(row, input);
    return reason.empty() ? idle(idle_on_works(row, works)) : reason;
  });
}

std::vector<IdleOption> options_without_effect(const PlanResult& result, const Toolpath& planned,
                                               const ResolvedPlan& plan, const PlanOptions& options) {
  const Asked asked{options, {}};
  const auto planner = plan.machine.planner ? plan.machine.planner : planner_of_control(plan);
  const Situation situation{plan, options, planned, result.selections, planner};
  return stated_without_effect(asked, [&](const Row& row) {
    if (row.group == Group::kController && row.name != "post")
      return idle(idle_in_program(row, result, planned, plan, asked));
    return row.effect.idle_because ? idle(row.effect.idle_because(situation)) : std::string();
  });
}

}  // namespace

void refuse_options_for_others(const ResolvedPlan& plan, const PlanOptions& asked) {
  if (!asked.refuse_idle) return;
  refuse_first(options_for_others(plan, asked));
  refuse_keys_for_others(plan, asked);
}

void refuse_idle_options(const PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan,
                         const PlanOptions& options) {
  if (!options.refuse_idle) return;
  refuse_first(options_without_effect(result, planned, plan, options));
}

std::vector<IdleOption> idle_options(const PlanResult& result, const ResolvedPlan& plan,
                                     const PlanOptions& asked) {
  std::vector<IdleOption> idle = options_for_others(plan, asked);
  for (IdleOption& one : options_without_effect(result, result.planned, plan, asked))
    idle.push_back(std::move(one));
  return idle;
}

}  // namespace clearcut::pipeline
