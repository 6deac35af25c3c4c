// Work permitted to each strategy for a workingstep.
#pragma once

#include <cstdint>
#include <vector>

#include "model/options/resolved_plan.h"
#include "pipeline/steps/step_work.h"

namespace clearcut::pipeline {

/// Steps of work (base/work_budget.h, about 8 us each) permitted to each strategy for all workingsteps if several are
/// tried; every workingstep has a share by its area, at least the smaller number.
inline constexpr std::uint64_t kMostWork = 500'000;
inline constexpr std::uint64_t kLeastWork = 50'000;
/// The same for one workingstep with a strategy requested by name, for which there is no alternative.
inline constexpr std::uint64_t kMostWorkAlone = 8'000'000;

/// For each workingstep: the steps of work permitted to a strategy.
std::vector<std::uint64_t> work_shares(const std::vector<StepWork>& works, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
