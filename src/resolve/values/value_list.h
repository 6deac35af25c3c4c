// Lists the decided values with their sources, for people and certificates.
#pragma once

#include "model/options/resolved_plan.h"
#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Place in the input of a step's operation: the source of all values without a source of their own.
Source read_source(const Part& part, const Workingstep& step);

/// Appends the values of one step of `plan` to plan.values; `sources` contains the sources that differ from the
/// operation's place in the input.
void list_step(ResolvedPlan& plan, int step, const Sources& sources, const PlanOptions& options);

/// Appends the values of the plan as a whole.
void list_plan(ResolvedPlan& plan, const PlanOptions& options);

}  // namespace clearcut::resolve
