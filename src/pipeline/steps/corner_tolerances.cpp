#include "pipeline/steps/corner_tolerances.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "kinematics/planner.h"
#include "model/results/findings.h"
#include "pipeline/steps/certify.h"
#include "post/post.h"

namespace clearcut::pipeline {
namespace {

/// Share of a section's time that more rounding must save at least: less is no reason for another word in the program.
constexpr double kLeastGain = 1e-3;
/// Attempts with as much less rounding as the figures ask for, first in the sections of faulty features, then everywhere, because
/// what is left of a feature depends on its neighbours' sections, too. Each costs one check of the program.
constexpr int kMostByFigures = 2;
/// mm; steps of stated roundings.
constexpr double kStep = 1e-4;

bool gains_by(double rounding, const Section& section, const ResolvedPlan& plan) {
  PathControl path = post::path_control_of(post_options_of(plan));
  const auto time = [&] {
    return kinematics::planned_time(section.moves, path, plan.machine, planner_of_control(plan)).seconds();
  };
  const double usual = time();
  path.tolerance_mm = rounding;
  return time() < (1 - kLeastGain) * usual;
}

/// mm of rounding that the figures of a feature show as too much: what is left grows by as much as corners are rounded. Infinite for
/// gouges, which depend on the corners' angles, too.
double excess_of(const Figures& figures, const Tolerances& tol) {
  if (figures.gouge_mm > tol.gouge) return HUGE_VAL;
  return std::max(0.0, figures.uncut_thickness_mm - tol.uncut);
}

/// mm; by feature.
std::map<int, double> excesses_of(const Findings& findings, const ResolvedPlan& plan) {
  std::map<int, double> excesses;
  for (const FeatureFindings& one : findings.features) {
    if (one.workingstep < 0) continue;
    double& excess = excesses[plan.part.workplan[static_cast<std::size_t>(one.workingstep)].feature];
    excess = std::max(excess, excess_of(one.figures, plan.tol));
  }
  return excesses;
}

/// mm; the greatest excess of a feature without gouges.
double greatest_of_uncut(const std::map<int, double>& excesses) {
  double greatest = 0;
  for (const auto& [feature, excess] : excesses)
    if (std::isfinite(excess)) greatest = std::max(greatest, excess);
  return greatest;
}

double narrower(double rounding, double excess, double least) {
  const double less = std::floor((rounding - excess) / kStep) * kStep;
  return std::isfinite(less) ? std::max(less, least) : least;
}

}  // namespace

std::vector<double> widest_corner_tolerances(const Toolpath& planned, const ResolvedPlan& plan) {
  const PostOptions post = post_options_of(plan);
  const double least = post.least_corner_tolerance();
  if (post.corner_tolerance.value_or(least) <= least) return {};
  if (post::path_control_of(post).mode != PathMode::kTolerance) return {};
  std::vector<double> roundings;
  for (const Section& section : planned.sections)
    roundings.push_back(gains_by(*post.corner_tolerance, section, plan) ? *post.corner_tolerance : least);
  return roundings;
}

bool narrow_corner_tolerances(PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan,
                              int tries) {
  const double least = post_options_of(plan).least_corner_tolerance();
  std::vector<double>& roundings = result.corner_tolerances;
  const auto is_wide = [&](double rounding) { return rounding > least; };
  if (verdict_of(result.findings) != Verdict::kFaulty ||
      std::none_of(roundings.begin(), roundings.end(), is_wide))
    return false;
  const std::map<int, double> excesses = excesses_of(result.findings, plan);
  bool any = false;
  for (std::size_t i = 0; tries <= kMostByFigures && i < roundings.size(); ++i) {
    const int step = planned.sections[i].workingstep;
    if (step < 0 || !is_wide(roundings[i])) continue;
    const auto of_feature = excesses.find(plan.part.workplan[static_cast<std::size_t>(step)].feature);
    double excess = of_feature == excesses.end() ? 0 : of_feature->second;
    if (tries > 1) excess = std::max(excess, greatest_of_uncut(excesses));
    if (excess <= 0) continue;
    roundings[i] = narrower(roundings[i], excess, least);
    any = true;
  }
  if (!any) std::fill(roundings.begin(), roundings.end(), least);
  return true;
}

void tell_corner_tolerances(const Toolpath& planned, const ResolvedPlan& plan, PlanResult& result) {
  std::vector<std::string> less;
  for (std::size_t i = 0; i < result.corner_tolerances.size(); ++i) {
    const double stated = result.corner_tolerances[i];
    const Section& section = planned.sections[i];
    if (section.moves.empty() || stated >= *plan.post.corner_tolerance) continue;
    std::string told = fmt::format("{} {}", section.label, trimmed(stated, 5));
    if (std::find(less.begin(), less.end(), told) == less.end()) less.push_back(std::move(told));
  }
  if (less.empty()) return;
  result.part.diagnostics.note(
      "corner-tolerance",
      fmt::format("the control may round corners by less than {} mm where more saves no time or "
                  "leaves too much: {}",
                  trimmed(*plan.post.corner_tolerance, 5), fmt::join(less, ", ")));
}

}  // namespace clearcut::pipeline
