// From a part to a program that was read back and certified.
//
//     std::stop_source stop;
//     PlanOptions options;
//     options.threads = 2;
//     options.cancel = stop.get_token();
//     options.progress = [](const Progress& at) { show(at.done, at.most); };
//     const PlanResult result = plan_part(part, options);  // throws Cancelled soon after stop.request_stop()
#pragma once

#include "base/progress.h"
#include "clearcut/part.h"
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

using pipeline::carried_stock;
using pipeline::CarriedStock;
using pipeline::cutting_of_tools;
using pipeline::MachinedSetup;
using pipeline::missing_of;
using pipeline::on_block;
using pipeline::options_of_job;
using pipeline::plan_part;
using pipeline::PlanResult;
using pipeline::read_earlier_program;
using pipeline::read_nested_parts;
using resolve::parse_keep_out;
using resolve::parse_predrilled;
using resolve::parse_stock;
using resolve::parse_tool;
using resolve::PlanOptions;
using resolve::ToolCutting;

// Names as options and files say them; unknown ones are an InputError that lists those there are.
using resolve::direction_named;
using resolve::entry_named;
using resolve::is_bisector_passage;
using resolve::is_published_grid;
using resolve::is_published_solver;
using resolve::is_reflex_corner;
using resolve::order_named;
using resolve::strategy_named;
using resolve::tab_shape_named;

/// Throws InputError naming the first option that is out of its range.
inline void check_options(const PlanOptions& options) {
  resolve::check(options);
}

/// Throws InputError where settings of the published solver are given, and the other is chosen.
inline void check_solver(const VisitSolver& solver) {
  resolve::check(solver, "--solver");
}

// What PlanOptions::strategy takes, and what it means.
using pipeline::description_of;
using pipeline::strategy_names;

/// Every value of a plan decided, each with where it comes from, as plan_part does it first.
inline ResolvedPlan resolve_plan(const Part& part, const PlanOptions& options) {
  return resolve::resolve(part, options, pipeline::strategies_of(options));
}

// The strategies there are; PlanOptions::strategies takes a table with more rows.
using pipeline::built_in_strategies;

// A part with every absent value decided, as plan_part does it first.
using features::largest_cutters;
using features::largest_fitting_diameter;
using resolve::prepare;
using resolve::with_tools;

/// Every strategy on one part, checked alike, as a table. Throws InputError where none can plan it.
inline report::TextTable compare_strategies(const Part& part, const PlanOptions& options) {
  return pipeline::compare(part, options);
}

// The same in its steps, with a count of plans while it runs.
using kinematics::published_time;
using kinematics::PublishedTime;
using pipeline::CountCallback;
using pipeline::fastest_clean;
using pipeline::run_strategies;
using pipeline::strategy_table;
using pipeline::StrategyRun;

// Which cutters, and in which sequence.
using pipeline::best_tool;
using pipeline::compare_tools;
using pipeline::fastest_sequence;
using pipeline::run_tools;
using pipeline::tool_table;
using pipeline::ToolComparison;
using pipeline::ToolRun;
using pipeline::ToolSequence;
using pipeline::ToolSpeeds;

}  // namespace clearcut
