// Refuses requested options without effect.
#pragma once

#include "pipeline/steps/plan_result.h"

namespace clearcut::pipeline {

/// Throws InputError for the first option of the user or of a job (by `asked.sources`) without effect in this plan,
/// naming its purpose. `planned` is the toolpath before posting.
void refuse_idle_options(const PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan,
                         const PlanOptions& asked);

}  // namespace clearcut::pipeline
