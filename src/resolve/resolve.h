// From a part and what a user asks to a plan in which every value is decided once, with its origin.
#pragma once

#include "model/options/resolved_plan.h"
#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// An option goes before what the part's operations say, that before the defaults; see docs/input.md. The values of the
/// result list each with where it came from. A strategy that a file names and `strategies` has not is noted in the part's
/// diagnostics, by workingstep; one that an option or a job names is an InputError.
ResolvedPlan resolve(const Part& part, const PlanOptions& options, const StrategyTable& strategies);

/// What the options say of a program that is for no part: limits, machine, material, tools. Its part has no work, and
/// Part::is_shape_stated is false. Throws InputError where there is no tool, or two have one number.
ResolvedPlan resolve_without_part(const PlanOptions& options);

}  // namespace clearcut::resolve
