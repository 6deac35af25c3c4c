// How much work each strategy may take for a workingstep.
#pragma once

#include <cstdint>
#include <vector>

#include "model/options/resolved_plan.h"
#include "pipeline/steps/step_work.h"

namespace clearcut::pipeline {

/// Steps of work (base/work_budget.h, about 8 us each) that each strategy may take for all workingsteps where several are
/// tried; every workingstep has its share of them by its area, and at least the lesser number.
inline constexpr std::uint64_t kMostWork = 500'000;
inline constexpr std::uint64_t kLeastWork = 50'000;
/// The same for one workingstep where a strategy is asked for by name, which there is nothing else for.
inline constexpr std::uint64_t kMostWorkAlone = 8'000'000;

/// For each workingstep: the steps of work that a strategy may take for it.
std::vector<std::uint64_t> work_shares(const std::vector<StepWork>& works, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
