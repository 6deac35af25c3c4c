// From a part as read and a user's options to a plan in which every value is decided once, with its origin: the steps
// that options add to a workplan, such as smaller tools for material left by larger ones and finishing, and the
// refusal of impossible requests and of those that would harm the machine.
#pragma once

#include <optional>

#include "model/options/resolved_plan.h"
#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// m/min at the circumference.
constexpr double kDefaultCuttingSpeed = 100;

/// The part with the user's options applied and every absent value filled in:
///
///   tool       from the options, else from the file; none at all is an InputError that names the largest fitting one
///   stepdown   option, operation, else half the diameter (face mills: 2 mm)
///   feed       option, operation, else 1000 mm/min; plunge 30 % of it, ramp 50 %
///   spindle    option, operation, else 100 m/min at the circumference, rounded to 10 rpm, no more than 24 000 if no
///              machine is stated
///   direction  climb
///
/// Defaulted values are noted in the diagnostics, once per value.
Part prepare(Part part, const PlanOptions& options);

/// The same; afterwards, `sources` contains the sources of all values that differ from the source of their operation.
Part prepare(Part part, const PlanOptions& options, StepSources& sources);

/// Whether the tool makes the feature at once, for any stepdown requested for all work: cones, taps, thread mills,
/// reamers and boring bars in holes.
bool is_made_at_once(const Feature& feature, const Tool& tool);

/// Gives a number to each tool without one. Throws InputError if two tools have the same number.
void number_tools(std::vector<Tool>& tools);

/// The part with the options' tools, else its own, else one end mill of half the largest fitting diameter (noted):
/// STEP-NC has no operation without a tool.
Part with_tools(Part part, const PlanOptions& options);

/// "walls", "floor", "all". Throws InputError for other names.
Finish finish_of(const ShopOptions& shop);

/// Whether programs are to have their control compensate for wear.
bool writes_wear(const ShopOptions& shop);

/// mm that D words may be off 0 either way.
double wear_range_of(const ShopOptions& shop);

/// Adds rest machining: for a milled feature one step more for each smaller mill of the part, on the stock that is left. With rest
/// machining asked for, every milled feature gets such steps, after all other steps and tool by tool. Otherwise only features get them
/// whose tool was chosen by size and that have other features below them: the stock left would be in the way of those, so that the
/// steps come before the first step of the features below.
void add_rest_steps(Part& part, const PlanOptions& options, StepSources& sources);

/// For every milled feature the finishing steps asked for, after all others, which leave stock for them: the floor with
/// the feature's first mill and what is left of it with its narrower ones, then the walls with its last, in
/// options.shop.finish_depths depths (drafted ones in the layers of roughing) and with leads of half the cutter's radius; in
/// finish_steps steps beside each other, the last of which is repeated spring_passes times.
void add_finishing_steps(Part& part, const PlanOptions& options, StepSources& sources);

/// `part` as read, with its stock. Throws InputError for features ending above the material, and for holes whose
/// material was removed before.
void refuse_above_stock(const Part& part);

/// Whether the step is one of a STEP-NC program, whose entities have numbers.
bool is_of_program(const Workingstep& step);

/// Features on which no workingstep works are no part of the job.
void drop_unused_features(Part& part);

/// `part` as prepared. Throws InputError, one line with the remedy, for: rapids at or below the top of the material; features
/// beside the material; floors below it that are no through cuts; floors farther below the material beside the tool than the flutes of
/// their tool are long, or (flutes unknown) features deeper than ten of its diameters, twenty for drills; cutters that
/// may not plunge and can go down no other way; features no deeper than the stock to leave on their floors; parts that take months of cutting; starts and predrilled holes that lie in no feature. Steps that unreached_steps() names are left out instead.
void refuse_what_cannot_be(const Part& part, const PlanOptions& options);

/// Warns of features no deeper than the permitted uncut thickness: the checks treat them as cut without any cutting.
void tell_of_shallow(Part& part, const Tolerances& tol);

/// For a STEP-NC program: `asked` without the workingsteps for which refuse_what_cannot_be() would refuse the whole
/// part, each reported as not machined; tops are computed from the remaining steps. Nothing if there are none, or no
/// other steps. `prepared`: `asked` with its tools.
std::optional<Part> without_impossible_steps(const Part& asked, const Part& prepared, const Tolerances& tol);

/// For a STEP-NC program: `asked` without the workingsteps above the stock, whose material earlier set-ups or a lower blank have taken, in
/// the same way.
std::optional<Part> without_steps_above_stock(const Part& asked, const Tolerances& tol);

/// An option takes precedence over the values of the part's operations, these over the defaults; see docs/input.md.
/// The values of the result are listed with their sources. A strategy named in a file but missing in `strategies` is
/// noted in the part's diagnostics, by workingstep; an unknown strategy of an option or a job is an InputError.
ResolvedPlan resolve(const Part& part, const PlanOptions& options, const StrategyTable& strategies);

/// As resolve(), without the workingsteps that the part's tools cannot make or that lie above its stock; see without_impossible_steps().
ResolvedPlan resolve_possible(const Part& part, const PlanOptions& options, const StrategyTable& strategies);

/// The options for a program without a part: limits, machine, material, tools. The result's part has no work, and
/// Part::is_shape_stated is false. Throws InputError if there is no tool, or if two have one number.
ResolvedPlan resolve_without_part(const PlanOptions& options);

}  // namespace clearcut::resolve
