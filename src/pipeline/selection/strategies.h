// The table of strategies, and which of them are planned for a workingstep.
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
const StrategyTable& strategies_of(const resolve::PlanOptions& options);

/// Names that --strategy takes, "auto" first.
std::vector<std::string> strategy_names(const StrategyTable& table = built_in_strategies());

/// Those that run contours: ours, then the corrected and the published methods.
const std::vector<std::string>& contour_method_names();

/// The step rule of a contour method that adds nothing to its contours; none for the others.
std::optional<plan::contour::StepRule> published_rule(const std::string& strategy);

/// What a name says, in one line for people.
std::string description_of(const std::string& strategy, const StrategyTable& table = built_in_strategies());

/// One way to plan a workingstep.
struct StrategyCandidate {
  const StrategyEntry* strategy = nullptr;
  Stepover stepover;
  bool beside_rivals = false;  ///< the strategy's rivals are planned too, and the fastest is taken
  bool briefly = false;        ///< where it searches, a short search will do: others are planned as well
  bool as_rival = false;  ///< planned beside another: kept only if it is faster and leaves nothing behind
};

/// The strategy of a candidate with the step's values bound in. Throws InputError for a stepover that means nothing to it.
Strategy strategy_for(const StrategyCandidate& candidate, const ResolvedStep& step, const ResolvedPlan& plan);

/// What is tried for a workingstep: those among which the fastest is kept, the surest first, and those tried
/// one after the other where none of them was certified clean.
struct StrategyCandidates {
  std::vector<StrategyCandidate> competing;
  std::vector<StrategyCandidate> fallbacks;
};
StrategyCandidates candidates_for(const ResolvedStep& step, const ResolvedPlan& plan,
                                  const StrategyTable& table);

}  // namespace clearcut::pipeline
