// Every strategy and rival on one part, checked alike.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/kinematics.h"
#include "model/results/findings.h"
#include "model/runs/comparison.h"
#include "report/words/text_table.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// Every strategy of the options' table. Throws InputError if none can plan the part. Cost one plan each.
std::vector<StrategyRun> run_strategies(const Part& part, const PlanOptions& options,
                                        const CountCallback& count = {});

/// The fastest run certified clean; null if none is.
const StrategyRun* fastest_clean(const std::vector<StrategyRun>& runs);

TextTable strategy_table(const Part& part, const PlanOptions& options, const std::vector<StrategyRun>& runs);

/// One row a strategy: lengths, times (of the whole program, kinematic; CPO-rho eq. 9 of its level feed moves), what is left, load,
/// verdict; the fastest clean row is marked. Strategies that cannot plan the part say why. Throws InputError where none can.
TextTable compare(const Part& part, const PlanOptions& options);

}  // namespace clearcut::pipeline
