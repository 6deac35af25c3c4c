// The table of strategies, and the choice of those planned for a workingstep.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/options/strategy_entry.h"
#include "plan/contour/contour.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// Those of the software.
const StrategyTable& built_in_strategies();

/// Those of the options, else those of the software.
inline const StrategyTable& strategies_of(const PlanOptions& options) {
  return options.strategies ? *options.strategies : built_in_strategies();
}

/// Valid names for --strategy, "auto" first.
std::vector<std::string> strategy_names(const StrategyTable& table = built_in_strategies());

/// The contour methods: Clearcut's own, then the corrected and the published methods.
const std::vector<std::string>& contour_method_names();

/// The step rule of a contour method without additional passes; none for the others.
std::optional<plan::contour::StepRule> published_rule(const std::string& strategy);

/// Description of a strategy's name, in one line for people.
std::string description_of(const std::string& strategy, const StrategyTable& table = built_in_strategies());

/// One candidate for planning a workingstep.
struct StrategyCandidate {
  const StrategyEntry* strategy = nullptr;
  Stepover stepover;
  bool beside_rivals = false;  ///< the strategy's rivals are planned too, and the fastest is taken
  bool briefly = false;        ///< a short search suffices, since other candidates are also planned
  bool as_rival = false;       ///< planned in addition to another: kept only if faster and without residuals
  double limit_share = 1;      ///< the share of the stated limit of engagement at which its cuts aim
  std::optional<ObjectiveKind> order = {};  ///< objective of its search, instead of the plan's
};

/// The strategy of a candidate with the step's values bound in. Throws InputError for a stepover unknown to the
/// strategy.
Strategy strategy_for(const StrategyCandidate& candidate, const ResolvedStep& step, const ResolvedPlan& plan);

/// Candidates for a workingstep: those of which the fastest is kept, the surest first, and fallbacks tried one after
/// the other if none of them was certified clean.
struct StrategyCandidates {
  std::vector<StrategyCandidate> competing;
  std::vector<StrategyCandidate> fallbacks;
};
StrategyCandidates candidates_for(const ResolvedStep& step, const ResolvedPlan& plan,
                                  const StrategyTable& table);

}  // namespace clearcut::pipeline
