// Writes down what was decided, with where it comes from, for people and certificates.
#pragma once

#include "model/options/resolved_plan.h"
#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Where the operation of a step was read: what its own sources do not name is from there.
Source read_source(const Part& part, const Workingstep& step);

/// Appends the values of one step of `plan` to plan.values; `sources` are those that are not from where the operation was
/// read.
void list_step(ResolvedPlan& plan, int step, const Sources& sources, const PlanOptions& options);

/// Appends the values of the plan as a whole.
void list_plan(ResolvedPlan& plan, const PlanOptions& options);

}  // namespace clearcut::resolve
