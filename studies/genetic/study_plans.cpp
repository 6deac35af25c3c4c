#include "studies/genetic/study_plans.h"

#include <fmt/format.h>

#include "base/error.h"
#include "order/genetic/crossover.h"
#include "order/genetic/mutation.h"
#include "order/genetic/selection.h"

namespace clearcut::studies {
namespace {

using enum StudyMetric;

StudyPlan plan_of(const char* name, const char* figure, const char* factor, StudyMetric metric,
                  StudySize ours, StudySize published, std::vector<std::string> levels) {
  return {name, figure, factor, metric, ours, published, std::move(levels)};
}

/// What the text studied of the algorithm itself.
std::vector<StudyPlan> plans_of_operators() {
  return {plan_of("population", "figure 4-14", "population", kFitness, {20, 20, 2000}, {50, 10000, 5'000'000},
                  {"5", "10", "15", "20", "25", "30", "40", "50"}),
          plan_of("selection", "figure 4-15", "selection", kImproved, {20, 30, 1000}, {50, 1100, 5'000'000},
                  order::selection_names()),
          plan_of("crossover", "figure 4-16", "crossover", kImproved, {20, 30, 1000}, {50, 10000, 5'000'000},
                  order::crossover_names()),
          plan_of("mutation", "figure 4-18", "mutation", kImproved, {20, 30, 1000}, {50, 10000, 5'000'000},
                  order::mutation_names())};
}

/// What the text studied of the size of the problem.
std::vector<StudyPlan> plans_of_sizes() {
  return {plan_of("size", "figures 6-1 and 6-2", "side", kFitness, {20, 10, 5000}, {50, 2000, 10'000'000},
                  {"5", "10", "15", "20", "25", "30"}),
          plan_of("time", "figure 6-3", "side", kSeconds, {20, 20, 1000}, {50, 2000, 1000},
                  {"5", "10", "15", "20", "25", "30"})};
}

/// What the text names without a figure, and the spread of its results.
std::vector<StudyPlan> plans_of_settings() {
  return {plan_of("crossover-rate", "section 3.9", "crossover rate", kFitness, {20, 10, 2000},
                  {50, 1100, 5'000'000}, {"0", "0.1", "0.2", "0.4", "0.8"}),
          plan_of("mutation-rate", "section 3.9", "mutation rate", kFitness, {20, 10, 2000},
                  {50, 1100, 5'000'000}, {"0.2", "0.4", "0.6", "0.8", "1"}),
          plan_of("neighbours", "section 4.3.2", "neighbours", kFitness, {20, 10, 2000},
                  {50, 1100, 5'000'000}, {"4", "8", "16", "24", "48"}),
          plan_of("sensitivity", "section 3.9, one factor at a time", "changed", kFitness, {20, 20, 2000},
                  {50, 1100, 5'000'000},
                  {"nothing", "population / 2", "population * 2", "crossover rate / 2", "crossover rate * 2",
                   "mutation rate / 2", "neighbours / 2", "neighbours * 2", "shared edges / 2",
                   "shared edges * 2"}),
          plan_of("spread", "figures 6-4 and 6-5", "none", kFitness, {30, 100, 5000}, {100, 2000, 3'000'000},
                  {"all"})};
}

std::vector<StudyPlan> all_plans() {
  std::vector<StudyPlan> all = plans_of_operators();
  for (const auto& more : {plans_of_sizes(), plans_of_settings()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace

const std::vector<StudyPlan>& study_plans() {
  static const std::vector<StudyPlan> all = all_plans();
  return all;
}

const StudyPlan& study_plan(const std::string& name) {
  std::string known;
  for (const StudyPlan& plan : study_plans()) {
    if (plan.name == name) return plan;
    known += (known.empty() ? "" : ", ") + plan.name;
  }
  throw InputError("study", fmt::format("'{}' is unknown; use one of {}", name, known));
}

}  // namespace clearcut::studies
