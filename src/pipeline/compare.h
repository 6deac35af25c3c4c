// Every strategy and rival on one part, checked alike.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/results/findings.h"
#include "report/words/text_table.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// Called before each of several plans and after the last: how many are done, of how many.
using CountCallback = std::function<void(std::size_t done, std::size_t of)>;

/// One strategy on the whole part.
struct StrategyRun {
  std::string strategy;
  std::optional<Figures> figures;  ///< none if the strategy cannot plan the part
  std::string refusal;             ///< and why
};

/// Every strategy of the options' table. Throws InputError if none can plan the part. Cost one plan each.
std::vector<StrategyRun> run_strategies(const Part& part, const resolve::PlanOptions& options,
                                        const CountCallback& count = {});

/// The fastest run certified clean; null if none is.
const StrategyRun* fastest_clean(const std::vector<StrategyRun>& runs);

report::TextTable strategy_table(const Part& part, const resolve::PlanOptions& options,
                                 const std::vector<StrategyRun>& runs);

/// One row for each strategy: lengths, times (kinematic; and CPO-rho eq. 9 with tau = 0.177 s), uncut material, load,
/// verdict; the fastest clean row is marked. Strategies that cannot plan the part have the reason instead. Throws
/// InputError if none can.
report::TextTable compare(const Part& part, const resolve::PlanOptions& options);

/// CPO-rho eq. 9: T = sum L / V_f + 2 (1 + nd) tau, nd the number of discontinuities, tau = 0.177 s.
double published_time(double naive_s, int discontinuities);

}  // namespace clearcut::pipeline
