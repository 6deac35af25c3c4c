// One workingstep planned by one strategy: passes layer by layer, linked, timed as the machine needs.
#pragma once

#include <cstdint>
#include <vector>

#include "model/options/resolved_plan.h"
#include "pipeline/selection/selection.h"
#include "pipeline/selection/strategies.h"
#include "pipeline/steps/step_work.h"

namespace clearcut::pipeline {

/// Candidates for each workingstep.
std::vector<SelectionStep> selection_steps(const ResolvedPlan& plan, const StrategyTable& strategies);

/// The plan of a strategy for one workingstep, within a number of work steps. Throws OutOfWork if it needs more.
StepPlan plan_step(const StepWork& work, const StrategyCandidate& candidate, const ResolvedPlan& job,
                   std::uint64_t most_work);

/// The plan of a candidate, or of a faster rival. Throws as plan_step().
StepPlan fastest_plan(const StepWork& work, const StrategyCandidate& candidate, const ResolvedPlan& job,
                      const StrategyTable& strategies, std::uint64_t most_work);

}  // namespace clearcut::pipeline
