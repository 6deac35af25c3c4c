// Options that were asked for and could do nothing.
#pragma once

#include "pipeline/steps/plan_result.h"

namespace clearcut::pipeline {

/// Throws InputError for the first option of the user or of a job, as `asked.sources` name them, that has no effect in this plan:
/// with what it serves. `planned` is the toolpath before it was posted.
void refuse_idle_options(const PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan,
                         const PlanOptions& asked);

}  // namespace clearcut::pipeline
