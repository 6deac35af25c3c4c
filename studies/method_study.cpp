#include "studies/method_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "pipeline/run.h"
#include "pipeline/selection/strategies.h"
#include "plan/contour/step_rule.h"
#include "studies/random_polygon.h"

namespace clearcut::studies {
namespace {

const std::string kOurs = "contour";

MethodOutcome outcome_of(const std::string& method, const Part& part, PlanOptions options) {
  options.strategy = method;
  // The causes that are told apart (plan/contour/ring_band.h) are those of contours whose reflex corners are round.
  options.published.sharp_reflex = options.published.sharp_reflex.value_or(false);
  MethodOutcome outcome;
  try {
    const auto result = pipeline::plan_part(part, options);
    const auto& figures = result.findings.all;
    outcome = {true, figures.clean, figures.time_s, figures.feed_mm, ""};
  } catch (const InputError&) {
    return outcome;
  }
  if (outcome.clean) return outcome;
  const auto rule = pipeline::published_rule(method);
  if (!rule) {
    outcome.cause = "as planned";
    return outcome;
  }
  const plan::contour::Rest rest = plan::contour::worst_rest(part.features.front().allowed, *rule,
                                                             part.tools.front().radius(), options.tol);
  outcome.cause = rest.cause == plan::contour::RestCause::kNone ? "other" : name_of(rest.cause);
  return outcome;
}

void find_faster(StudyCase& one) {
  const auto& ours = one.outcomes.at(kOurs);
  double best = ours.clean ? ours.time_s * (1 - kSlower) : std::numeric_limits<double>::infinity();
  for (const auto& [method, outcome] : one.outcomes) {
    if (method == kOurs || !outcome.clean || outcome.time_s >= best) continue;
    best = outcome.time_s;
    one.faster = method;
  }
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<std::string> row_of(const std::string& method, const MethodStudy& study) {
  int clean = 0, faster = 0;
  std::vector<double> ratios;
  std::map<std::string, int> causes;
  for (const auto& one : study.cases) {
    const auto& theirs = one.outcomes.at(method);
    const auto& ours = one.outcomes.at(kOurs);
    clean += theirs.clean;
    if (!theirs.clean) ++causes[theirs.planned ? theirs.cause : "not planned"];
    if (!theirs.clean || !ours.clean) continue;
    ratios.push_back(theirs.time_s / ours.time_s);
    faster += theirs.time_s < ours.time_s * (1 - kSlower);
  }
  std::string why;
  for (const auto& [cause, times] : causes)
    why += fmt::format("{}{} {}", why.empty() ? "" : ", ", times, cause);
  return {method, std::to_string(clean), fmt::format("{:.3f}", median(ratios)), std::to_string(faster), why};
}

}  // namespace

MethodStudy study_methods(int count, std::uint64_t first_seed, const PlanOptions& options,
                          const std::function<void(const StudyCase&)>& done) {
  MethodStudy study;
  for (int i = 0; i < count; ++i) {
    StudyCase one;
    one.seed = first_seed + static_cast<std::uint64_t>(i);
    one.part = random_pocket(one.seed, options.tol).part;
    for (const auto& method : pipeline::contour_method_names())
      one.outcomes[method] = outcome_of(method, one.part, options);
    find_faster(one);
    done(one);
    study.cases.push_back(std::move(one));
  }
  return study;
}

TextTable study_table(const MethodStudy& study) {
  TextTable table;
  table.title =
      fmt::format("{} random pockets: convex, acute, concave, with arcs, with islands", study.cases.size());
  table.columns = {{"method", Align::kLeft},
                   {"clean"},
                   {"median time x ours"},
                   {"faster than ours"},
                   {"left, by cause", Align::kLeft}};
  for (const auto& method : pipeline::contour_method_names()) table.add(row_of(method, study));
  table.notes.push_back(
      "times are kinematic, over pockets that both leave clean; faster: by more than 0.1 %");
  return table;
}

}  // namespace clearcut::studies
