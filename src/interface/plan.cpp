// Functions of include/clearcut/plan.h, by calls of the stages.
#include <clearcut/plan.h>

#include <utility>

#include "features/tool_choice.h"
#include "kinematics/kinematics.h"
#include "pipeline/compare.h"
#include "pipeline/job_options.h"
#include "pipeline/run.h"
#include "pipeline/selection/strategies.h"
#include "pipeline/setups/carried_stock.h"
#include "pipeline/setups/solid_stock.h"
#include "pipeline/stated_machine.h"
#include "pipeline/tool_sets.h"
#include "resolve/resolve.h"
#include "resolve/values/names.h"
#include "resolve/values/plan_options.h"

namespace clearcut {

CarriedStock carried_stock(const std::vector<MachinedSetup>& earlier, const SetupPlace& place,
                           const Part& next) {
  return pipeline::carried_stock(earlier, place, next);
}

std::vector<ToolCutting> cutting_of_tools(const std::vector<LibraryTool>& tools, const std::string& preset) {
  return pipeline::cutting_of_tools(tools, preset);
}

Toolpath missing_of(Part stock, const Stock& block, const std::vector<Tool>& tools) {
  return pipeline::missing_of(std::move(stock), block, tools);
}

Part on_block(Part part, const Stock& left) {
  return pipeline::on_block(std::move(part), left);
}

PlanOptions options_of_job(const JobFile& job) {
  return pipeline::options_of_job(job);
}

PlanResult plan_part(const Part& part, const PlanOptions& options) {
  return pipeline::plan_part(part, options);
}

void read_earlier_program(PlanOptions& options, const std::string& file, std::optional<Dialect> dialect) {
  pipeline::read_earlier_program(options, file, dialect);
}

std::vector<NestedPart> read_nested_parts(const PlanOptions& options, const std::optional<JobFile>& of_first,
                                          const ReadOptions& over) {
  return pipeline::read_nested_parts(options, of_first, over);
}

KeepOut parse_keep_out(const std::string& text) {
  return resolve::parse_keep_out(text);
}

PredrilledHole parse_predrilled(const std::string& text) {
  return resolve::parse_predrilled(text);
}

Stock parse_stock(const std::string& text, double top) {
  return resolve::parse_stock(text, top);
}

Tool parse_tool(const std::string& text) {
  return resolve::parse_tool(text);
}

CutDirection direction_named(const std::string& name, const std::string& place) {
  return resolve::direction_named(name, place);
}

EntryKind entry_named(const std::string& name, const std::string& place) {
  return resolve::entry_named(name, place);
}

bool is_bisector_passage(const std::string& name, const std::string& place) {
  return resolve::is_bisector_passage(name, place);
}

bool is_published_grid(const std::string& name, const std::string& place) {
  return resolve::is_published_grid(name, place);
}

bool is_published_solver(const std::string& name, const std::string& place) {
  return resolve::is_published_solver(name, place);
}

bool is_reflex_corner(const std::string& name, const std::string& place) {
  return resolve::is_reflex_corner(name, place);
}

ContourOrder order_named(const std::string& name, const std::string& place) {
  return resolve::order_named(name, place);
}

const StrategyEntry* strategy_named(const std::string& name, const StrategyTable& strategies,
                                    const std::string& place) {
  return resolve::strategy_named(name, strategies, place);
}

TabShape tab_shape_named(const std::string& name, const std::string& place) {
  return resolve::tab_shape_named(name, place);
}

std::string description_of(const std::string& strategy, const StrategyTable& table) {
  return pipeline::description_of(strategy, table);
}

std::vector<std::string> strategy_names(const StrategyTable& table) {
  return pipeline::strategy_names(table);
}

const StrategyTable& built_in_strategies() {
  return pipeline::built_in_strategies();
}

std::vector<double> largest_cutters(const Part& part, const Tolerances& tol) {
  return features::largest_cutters(part, tol);
}

double largest_fitting_diameter(const Feature& feature, const Tolerances& tol) {
  return features::largest_fitting_diameter(feature, tol);
}

Part prepare(Part part, const PlanOptions& options) {
  return resolve::prepare(std::move(part), options);
}

Part prepare(Part part, const PlanOptions& options, StepSources& sources) {
  return resolve::prepare(std::move(part), options, sources);
}

Part with_tools(Part part, const PlanOptions& options) {
  return resolve::with_tools(std::move(part), options);
}

PublishedTime published_time(const Toolpath& toolpath) {
  return kinematics::published_time(toolpath);
}

const ToolRun* fastest_clean(const std::vector<ToolRun>& runs) {
  return pipeline::fastest_clean(runs);
}

const StrategyRun* fastest_clean(const std::vector<StrategyRun>& runs) {
  return pipeline::fastest_clean(runs);
}

std::vector<StrategyRun> run_strategies(const Part& part, const PlanOptions& options,
                                        const CountCallback& count) {
  return pipeline::run_strategies(part, options, count);
}

TextTable strategy_table(const Part& part, const PlanOptions& options, const std::vector<StrategyRun>& runs) {
  return pipeline::strategy_table(part, options, runs);
}

const ToolRun* best_tool(const ToolComparison& comparison) {
  return pipeline::best_tool(comparison);
}

ToolComparison compare_tools(const Part& part, const ToolSpeeds& speeds, const PlanOptions& options,
                             const CountCallback& count) {
  return pipeline::compare_tools(part, speeds, options, count);
}

std::optional<ToolSequence> fastest_sequence(const Part& part, const ToolSpeeds& speeds,
                                             const PlanOptions& options) {
  return pipeline::fastest_sequence(part, speeds, options);
}

std::vector<ToolRun> run_tools(const Part& part, const ToolSpeeds& speeds, const PlanOptions& options,
                               const CountCallback& count) {
  return pipeline::run_tools(part, speeds, options, count);
}

TextTable tool_table(const Part& part, const ToolSpeeds& speeds, const ToolComparison& comparison) {
  return pipeline::tool_table(part, speeds, comparison);
}

Machine with_typed(Machine machine, const TypedMachine& typed) {
  return pipeline::with_typed(machine, typed);
}

void accept_what_is_held(const Sources& of_machine, PlanOptions& options) {
  pipeline::accept_what_is_held(of_machine, options);
}

void add_places(const std::vector<std::string>& keep_outs, const std::vector<std::string>& predrilled,
                PlanOptions& options) {
  resolve::add_places(keep_outs, predrilled, options);
}

void check_options(const PlanOptions& options) {
  resolve::check(options);
}

void check_solver(const VisitSolver& solver) {
  resolve::check(solver, "--solver");
}

ResolvedPlan resolve_plan(const Part& part, const PlanOptions& options) {
  return resolve::resolve(part, options, pipeline::strategies_of(options));
}

TextTable compare_strategies(const Part& part, const PlanOptions& options) {
  return pipeline::compare(part, options);
}

}  // namespace clearcut
