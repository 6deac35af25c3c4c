#include "studies/genetic/study_plans.h"

#include <fmt/format.h>

#include "base/error.h"
#include "order/genetic/operators.h"
#include "order/genetic/selection.h"

namespace clearcut::studies {
namespace {

using enum StudyMetric;

using Kind = StudyClaim::Kind;

/// What the text studied of the algorithm itself.
std::vector<StudyPlan> plans_of_operators() {
  return {
      {.name = "population",
       .figure = "figure 4-14",
       .factor = "population",
       .metric = kFitness,
       .ours = {20, 20, 2000},
       .middle = {20, 5, 20000},
       .published = {50, 10000, 5'000'000},
       .levels = {"5", "10", "15", "20", "25", "30", "40", "50"},
       .claims = {{Kind::kAbove, "25", "20"},
                  {Kind::kAbove, "25", "5"},
                  {Kind::kNotBelow, "25", "30"},
                  {Kind::kNotBelow, "25", "50"}}},
      {.name = "selection",
       .figure = "figure 4-15",
       .factor = "selection",
       .metric = kImproved,
       .ours = {20, 30, 1000},
       .middle = {20, 12, 10000},
       .published = {50, 1100, 5'000'000},
       .levels = order::selection_names(),
       .claims = {{Kind::kAbove, "roulette", "rank"},
                  {Kind::kAbove, "roulette", "random"},
                  {Kind::kAbove, "rank", "random"}}},
      {.name = "crossover",
       .figure = "figure 4-16",
       .factor = "crossover",
       .metric = kImproved,
       .ours = {20, 30, 1000},
       .middle = {20, 8, 6000},
       .published = {50, 10000, 5'000'000},
       .levels = order::crossover_names(),
       .claims = {{Kind::kAlike, "erx", "pmx"}, {Kind::kAbove, "pmx", "ox"}, {Kind::kAbove, "erx", "ox"}}},
      {.name = "mutation",
       .figure = "figure 4-18",
       .factor = "mutation",
       .metric = kImproved,
       .ours = {20, 30, 1000},
       .middle = {20, 8, 6000},
       .published = {50, 10000, 5'000'000},
       .levels = order::mutation_names(),
       .claims = {{Kind::kAbove, "nearest", "exchange"}, {Kind::kAbove, "nearest", "inversion"}}}};
}

/// What the text studied of the size of the problem.
std::vector<StudyPlan> plans_of_sizes() {
  const std::vector<std::string> sides{"5", "10", "15", "20", "25", "30"};
  return {
      {.name = "size",
       .figure = "figures 6-1 and 6-2",
       .factor = "side",
       .metric = kFitness,
       .ours = {20, 10, 5000},
       .middle = {20, 3, 60000},
       .published = {50, 2000, 10'000'000},
       .levels = sides,
       .claims = {{Kind::kAbove, "10", "20"}, {Kind::kAbove, "20", "30"}, {Kind::kIs, "30", "", "", 97.2}}},
      {.name = "time",
       .figure = "figure 6-3",
       .factor = "side",
       .metric = kSeconds,
       .ours = {20, 20, 1000},
       .middle = {20, 100, 1000},
       .published = {50, 2000, 1000},
       .levels = sides,
       .claims = {{Kind::kFasterThanAnyLine, "10", "20", "30"}}}};
}

/// What the text names without a figure, and the spread of its results.
std::vector<StudyPlan> plans_of_settings() {
  const StudySize brief{20, 10, 2000}, middle{20, 6, 20000}, published{50, 1100, 5'000'000};
  const auto without_finding = [&](const char* name, const char* figure, const char* factor,
                                   std::vector<std::string> levels) {
    return StudyPlan{.name = name,
                     .figure = figure,
                     .factor = factor,
                     .metric = kFitness,
                     .ours = brief,
                     .middle = middle,
                     .published = published,
                     .levels = std::move(levels)};
  };
  StudyPlan sensitivity = without_finding(
      "sensitivity", "section 3.9, one factor at a time", "changed",
      {"nothing", "population / 2", "population * 2", "crossover rate / 2", "crossover rate * 2",
       "mutation rate / 2", "neighbours / 2", "neighbours * 2", "shared edges / 2", "shared edges * 2"});
  sensitivity.ours.runs = 20;
  StudyPlan spread = without_finding("spread", "figures 6-4 and 6-5", "none", {"all"});
  spread.ours = {30, 100, 5000};
  spread.middle = {30, 6, 60000};
  spread.published = {100, 2000, 3'000'000};
  spread.claims = {{Kind::kIs, "all", "", "", 97.3}, {Kind::kWithin, "all", "", "", 0.58}};
  return {
      without_finding("crossover-rate", "section 3.9", "crossover rate", {"0", "0.1", "0.2", "0.4", "0.8"}),
      without_finding("mutation-rate", "section 3.9", "mutation rate", {"0.2", "0.4", "0.6", "0.8", "1"}),
      without_finding("neighbours", "section 4.3.2", "neighbours", {"4", "8", "16", "24", "48"}),
      std::move(sensitivity), std::move(spread)};
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
