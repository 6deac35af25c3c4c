// From a part and a user's options to a plan in which every value is decided once, with its origin.
#pragma once

#include "model/options/resolved_plan.h"
#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// An option takes precedence over the values of the part's operations, these over the defaults; see docs/input.md.
/// The values of the result are listed with their sources. A strategy named in a file but missing in `strategies` is
/// noted in the part's diagnostics, by workingstep; an unknown strategy of an option or a job is an InputError.
ResolvedPlan resolve(const Part& part, const PlanOptions& options, const StrategyTable& strategies);

/// As resolve(), without the workingsteps that the part's tools cannot make; see without_impossible_steps().
ResolvedPlan resolve_possible(const Part& part, const PlanOptions& options, const StrategyTable& strategies);

/// The options for a program without a part: limits, machine, material, tools. The result's part has no work, and
/// Part::is_shape_stated is false. Throws InputError if there is no tool, or if two have one number.
ResolvedPlan resolve_without_part(const PlanOptions& options);

}  // namespace clearcut::resolve
