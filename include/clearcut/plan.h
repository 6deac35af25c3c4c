// From a part to a program that was read back and certified.
//
//     std::stop_source stop;
//     PlanOptions options;
//     options.threads = 2;
//     options.cancel = stop.get_token();
//     options.progress = [](const Progress& at) { show(at.done, at.most); };
//     const PlanResult result = plan_part(part, options);  // throws Cancelled soon after stop.request_stop()
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "clearcut/part.h"
#include "clearcut/text.h"
#include "model/results/machined_setup.h"
#include "model/results/published_time.h"
#include "model/runs/comparison.h"
#include "model/runs/plan_result.h"
#include "options/plan_options.h"
#include "options/tool_speeds.h"
#include "options/typed_machine.h"

namespace clearcut {

/// The stock of a later set-up at `place` with the part `next`.
CarriedStock carried_stock(const std::vector<MachinedSetup>& earlier, const SetupPlace& place,
                           const Part& next);

/// Cutting data stated by a library for its tools, in their order; `preset` names one of several sets, "" the first.
std::vector<ToolCutting> cutting_of_tools(const std::vector<LibraryTool>& tools, const std::string& preset);

/// The volume of its block missing in the solid `stock`, as cuts that count as made before: straight down by the
/// narrowest flat mill among `tools`, everywhere within its reach. `stock` must be read with SolidOptions::is_stock.
/// `block`: place of its block in the coordinates of the part, which was read with it (ReadOptions::block) and may
/// have another zero since. Throws InputError if no tool is a flat mill.
Toolpath missing_of(Part stock, const Stock& block, const std::vector<Tool>& tools);

/// `part` on the block that earlier set-ups have left. Workingsteps of a STEP-NC program whose features lie inside the
/// part's own block and above what is left are left out with a note: there is nothing for them to cut. Throws
/// NothingToMachine, which is done, if these are all and no other was left out.
Part on_block(Part part, const Stock& left);

/// The options of a job's [plan], [machine] and [output] with their sources, and the cutting data of its tools. Its
/// operations are already in its part, see part_of_job. Reads the job's tool library and the earlier program. Throws
/// InputError for unknown strategies, even if overridden by a later rule, and for unreadable files.
PlanOptions options_of_job(const JobFile& job);

/// Plans, posts and certifies a part, or the copies of it that options.copies asks for.
/// Safe to call from several threads at once, each call with its own options. Throws InputError if the options cannot
/// be met or nothing at all can be cut, Cancelled if options.cancel requests a stop.
PlanResult plan_part(const Part& part, const PlanOptions& options);

/// Reads into `options` an earlier program on the same stock on options.machine: its moves, the state of the control
/// meanwhile, and the conditions for these moves. `dialect`: the control; absent, or if it does not accept the
/// program: recognised. Throws InputError.
void read_earlier_program(PlanOptions& options, const std::string& file, std::optional<Dialect> dialect = {});

/// The parts of options.copies.with, each read from its file with the options `over` as the first part was, of a job with what the job
/// `of_first` says of all parts: its [part] without places, its tools, its [plan] and the operations of "*". A job is read as it is.
/// Numbers of outlines are those of the first part's drawing alone.
std::vector<NestedPart> read_nested_parts(const PlanOptions& options, const std::optional<JobFile>& of_first,
                                          const ReadOptions& over);

/// "-10:15,20:40,-20:12": the block of a clamp as ranges of x, y and z, mm or with units. Throws InputError.
KeepOut parse_keep_out(const std::string& text);

/// "X,Y:D": a hole of diameter D at (X, Y), mm. Throws InputError.
PredrilledHole parse_predrilled(const std::string& text);

/// "100,60,20": the block's size, from X 0 and Y 0 and down from `top`; or each of the three as LOW:HIGH,
/// "-5:95,0:60,-20:0". mm, or with units as lengths everywhere. Throws InputError.
Stock parse_stock(const std::string& text, double top = 0);

/// "endmill:10[:T3][:flutes=2][:corner=0.5][:max_spindle=12000][:name=ROUGHER][:noplunge]", "tap:M6[:floating]".
/// Throws InputError.
Tool parse_tool(const std::string& text);

// Names as options and files say them; unknown ones are an InputError that lists those there are.

/// "climb", "conventional". Throws InputError at `place`.
CutDirection direction_named(const std::string& name, const std::string& place);

/// "helix", "ramp", "zigzag", "plunge". Throws InputError at `place`.
EntryKind entry_named(const std::string& name, const std::string& place);

/// Published method or Clearcut's own: "bisector" or "shortest" passages, a "corner" or "round" contours at reflex
/// corners, the "published" grid or "ours", the "published" solver or the "modern" one; true for the published one.
/// Throw InputError at `place`.
bool is_bisector_passage(const std::string& name, const std::string& place);
bool is_published_grid(const std::string& name, const std::string& place);
bool is_published_solver(const std::string& name, const std::string& place);
bool is_reflex_corner(const std::string& name, const std::string& place);

/// "inside-out", "outside-in". Throws InputError at `place`.
ContourOrder order_named(const std::string& name, const std::string& place);

/// The row of a strategy; null for "auto". Throws InputError at `place`, listing the existing names.
const StrategyEntry* strategy_named(const std::string& name, const StrategyTable& strategies,
                                    const std::string& place);

/// "square", "triangular". Throws InputError at `place`.
TabShape tab_shape_named(const std::string& name, const std::string& place);

/// Throws InputError naming the first option that is out of its range.
void check_options(const PlanOptions& options);

/// Throws InputError where settings of the published solver are given, and the other is chosen.
void check_solver(const VisitSolver& solver);

/// The strategies of the software; PlanOptions::strategies takes a table with more rows.
const StrategyTable& built_in_strategies();

/// Description of a strategy's name, in one line for people.
std::string description_of(const std::string& strategy, const StrategyTable& table = built_in_strategies());

/// Valid names for --strategy, "auto" first.
std::vector<std::string> strategy_names(const StrategyTable& table = built_in_strategies());

/// Every value of a plan decided, each with where it comes from, as plan_part does it first.
ResolvedPlan resolve_plan(const Part& part, const PlanOptions& options);

/// Diameter of the largest cutter that has a legal position over the feature's floor, mm; 0 when none. At open
/// sides only places over the feature itself count.
double largest_fitting_diameter(const Feature& feature, const Tolerances& tol);

/// For each feature the diameter of the largest cutter that is worth a try, mm: as largest_fitting_diameter(), and where sides are open also a wider one that
/// comes in from outside and reaches nine tenths of the floor. Features in a row with the same walls share the work.
std::vector<double> largest_cutters(const Part& part, const Tolerances& tol);

/// The part with the user's options applied and every absent value filled in, as plan_part() does it first. Throws InputError.
Part prepare(Part part, const PlanOptions& options);

/// The same; afterwards, `sources` contains the sources of all values that differ from the source of their operation.
Part prepare(Part part, const PlanOptions& options, StepSources& sources);

/// The part with the options' tools, else its own, else one end mill of half the largest fitting diameter (noted):
/// STEP-NC has no operation without a tool.
Part with_tools(Part part, const PlanOptions& options);

/// Every strategy on one part, checked alike, as a table. Throws InputError where none can plan it.
TextTable compare_strategies(const Part& part, const PlanOptions& options);

// The same in its steps, with a count of plans while it runs.

/// Equation 9 of CPO-rho for a toolpath. Level feed moves count: contours, passages between them and links at depth, the segments of the result file.
/// Plunges, ramps, retracts and rapids do not; feed moves without a feed have no time.
PublishedTime published_time(const Toolpath& toolpath);

/// The fastest run certified clean; null if none is.
const ToolRun* fastest_clean(const std::vector<ToolRun>& runs);

/// The fastest run certified clean; null if none is.
const StrategyRun* fastest_clean(const std::vector<StrategyRun>& runs);

/// Every strategy of the options' table. Throws InputError if none can plan the part. Cost one plan each.
std::vector<StrategyRun> run_strategies(const Part& part, const PlanOptions& options,
                                        const CountCallback& count = {});
TextTable strategy_table(const Part& part, const PlanOptions& options, const std::vector<StrategyRun>& runs);

// Which cutters, and in which sequence.

/// The best run, marked in tables; null if none is clean.
const ToolRun* best_tool(const ToolComparison& comparison);

/// Throws InputError if no cutter can be used. `count` is called for the plans of single cutters and of pairs.
ToolComparison compare_tools(const Part& part, const ToolSpeeds& speeds, const PlanOptions& options,
                             const CountCallback& count = {});

/// The fastest sequence that leaves no more than the smallest cutter by itself; none if no sequence can be cut clean.
/// Each cutter cuts the areas out of reach of larger ones, which depend only on the previous cutter: a shortest path
/// over pairs. Cost: one plan for every pair of tools.
std::optional<ToolSequence> fastest_sequence(const Part& part, const ToolSpeeds& speeds,
                                             const PlanOptions& options);

/// Runs every tool of the options (else of the part) by itself on every feature, smallest first. Throws InputError
/// without tools and for speeds not above 0. Cost one plan each.
std::vector<ToolRun> run_tools(const Part& part, const ToolSpeeds& speeds, const PlanOptions& options,
                               const CountCallback& count = {});

/// The table, with the best clean cutter marked, and the fastest sequence or the load of each below.
TextTable tool_table(const Part& part, const ToolSpeeds& speeds, const ToolComparison& comparison);

/// `machine` with the usual values of the typed kind where it states none, and with the typed values, which go before those of single
/// axes.
Machine with_typed(Machine machine, const TypedMachine& typed);

/// A machine file, or a job's machine table, with the key `holding` states how loose parts are held, and so meets the condition
/// `loose-part`. `of_machine`: the sources of its values.
void accept_what_is_held(const Sources& of_machine, PlanOptions& options);

/// Adds clamps, and holes that exist before the work begins. Throws InputError.
void add_places(const std::vector<std::string>& keep_outs, const std::vector<std::string>& predrilled,
                PlanOptions& options);

}  // namespace clearcut
