// The strategies by name, behind one signature.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/layer.h"
#include "model/pass.h"
#include "plan/contour/contour.h"
#include "resolve/plan_options.h"

namespace clearcut::pipeline {

/// Names that --strategy takes, "auto" first.
const std::vector<std::string>& strategy_names();

/// Those that run contours: ours, then the corrected and the published methods.
const std::vector<std::string>& contour_method_names();

/// The step rule of a contour method that adds nothing to its contours; none for the others.
std::optional<plan::contour::StepRule> published_rule(const std::string& strategy);

/// The step rule that the options stand for with any contour method but ours; none for other strategies.
std::optional<plan::contour::StepRule> contour_rule(const resolve::PlanOptions& options);

/// What a name says, in one line for people.
std::string description_of(const std::string& strategy);

/// One way to plan: a strategy by name (not "auto") with its stepover, where one is set.
struct Attempt {
  std::string strategy;
  std::optional<std::string> stepover;
  bool beside_rivals = false;  ///< the published ways to clear rests are tried too, and the fastest is taken
  bool briefly = false;        ///< where it searches, a short search will do: others are planned as well
};

/// What an attempt beside rivals is measured against: methods that leave nothing by construction.
const std::vector<Attempt>& rival_attempts();

/// The strategy of an attempt with the operation's feed and the options' limits bound in.
/// Throws InputError for an unknown name or a stepover that cannot be read.
Strategy strategy_for(const Attempt& attempt, const Operation& operation,
                      const resolve::PlanOptions& options);

/// What the wanted strategy stands for: those among which the fastest is kept, the surest first, and those tried
/// one after the other where none of them was certified clean.
struct Attempts {
  std::vector<Attempt> contest;
  std::vector<Attempt> fallbacks;
};
Attempts attempts_for(const resolve::PlanOptions& options);

}  // namespace clearcut::pipeline
