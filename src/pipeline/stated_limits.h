// Limits that the user states and that no plan can hold: refused, rather than planned and judged faulty.
#pragma once

#include "model/options/resolved_plan.h"
#include "model/results/findings.h"
#include "pipeline/steps/certify.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// Whether a workingstep engages the cutter by more than the stated limit and what is no fault above this limit.
bool exceeds_engagement(const FeatureFindings& step, const ResolvedPlan& plan);

/// Throws InputError for spindle speeds that the machine, or the tool, does not have.
void refuse_beyond_machine(const ResolvedPlan& plan);

/// Throws InputError for a limit on the engagement that the program exceeds since nothing could hold it: profiles are
/// cut at the full width of the cutter, and a stated strategy may begin with such cuts. A program that holds the limit
/// nevertheless is right.
void refuse_exceeded_engagement(const PlanResult& result, const ResolvedPlan& plan,
                                const PlanOptions& options);

}  // namespace clearcut::pipeline
