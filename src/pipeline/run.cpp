#include "pipeline/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/progress.h"
#include "base/text.h"
#include "geometry/voronoi/clearance.h"
#include "model/results/findings.h"
#include "pipeline/job_options.h"
#include "pipeline/planning.h"
#include "pipeline/result_figures.h"
#include "pipeline/selection/choice.h"
#include "pipeline/selection/selection.h"
#include "pipeline/selection/strategies.h"
#include "pipeline/stated_limits.h"
#include "pipeline/steps/certify.h"
#include "pipeline/steps/corner_tolerances.h"
#include "pipeline/steps/out_of_reach.h"
#include "pipeline/steps/program_conditions.h"
#include "pipeline/steps/step_work.h"
#include "resolve/resolve.h"

namespace clearcut::pipeline {
namespace {

/// Whether another plan of a workingstep may avoid the fault. The workingsteps of one feature share its name; an
/// exceeded limit of engagement in finishing its walls does not concern the clearing before.
bool may_be_avoided(const Fault& fault, const FeatureFindings& step, const ResolvedPlan& plan) {
  if (fault.feature != step.name || !row_of(fault.kind).by_strategy) return false;
  return fault.kind != FaultKind::kOverEngagement || exceeds_engagement(step, plan);
}

/// Takes the next best plan of every workingstep that was not certified clean. False if there was none.
bool retry_unclean(Selection& selection, const ResolvedPlan& plan, PlanResult& result) {
  bool retried = false;
  for (const auto& feature : result.findings.features) {
    if (feature.figures.clean || feature.workingstep < 0) continue;
    const auto& faults = result.findings.faults;
    if (std::none_of(faults.begin(), faults.end(),
                     [&](const Fault& fault) { return may_be_avoided(fault, feature, plan); }))
      continue;
    const auto i = static_cast<std::size_t>(feature.workingstep);
    const Tool& tool = tool_of(result.part, result.part.workplan[i]);
    if (tool.corner_radius >= tool.radius()) continue;  // no passes leave a floor flat
    if (!selection.next(i)) continue;
    const StrategyCandidate& next = selection.candidate(i);
    result.part.diagnostics.note(
        feature.name, "was not certified clean at first and is planned again: " + next.strategy->name +
                          (next.stepover.is_given() ? ", stepover " + next.stepover.text : "") +
                          (next.limit_share < 1 ? fmt::format(", aiming at {} of the limit of engagement",
                                                              trimmed(next.limit_share, 2))
                                                : ""));
    retried = true;
  }
  return retried;
}

/// Whether rapids touch material that stands beside or above what is cut: left by passes by design, or by earlier
/// layers outside of an open pocket. The same passes are then linked again with rapids above this material, with a
/// diagnostic. False if the rapids are already above.
bool begin_to_go_over_rests(bool& over_rests, PlanResult& result) {
  const int met = result.findings.all.rapid_in_material;
  if (over_rests || met == 0) return false;
  over_rests = true;
  result.part.diagnostics.note(
      "plan", fmt::format("{} would meet what the passes before leave: rapids end above it, the rest is fed",
                          met == 1 ? "1 rapid" : fmt::format("{} rapids", met)));
  return true;
}

/// Number of candidates that the selection may plan before any fallback.
std::size_t candidates_in(const std::vector<SelectionStep>& steps) {
  std::size_t count = 0;
  for (const SelectionStep& step : steps) count += step.candidates.competing.size();
  return count;
}

/// Refuses impossible requests, and reports requests without effect.
void look_at_what_is_asked(const ResolvedPlan& plan, const PlanOptions& options, Part& part) {
  resolve::refuse_what_cannot_be(part, options);
  refuse_options_for_others(plan, options);
  refuse_beyond_machine(plan);
  resolve::tell_of_shallow(part, options.tol);
  refuse_what_means_nothing(plan, part.diagnostics);
  warn_of_both_ways(plan, part.diagnostics);
  tell_program_number(plan, part.diagnostics);
}

/// Plans every workingstep by its candidates.
Selection planned_selection(const std::vector<StepWork>& works, const ResolvedPlan& plan,
                            const StrategyTable& strategies, ProgressMeter& meter) {
  const auto shares = work_shares(works, plan);
  const auto steps = selection_steps(plan, strategies);
  meter.begin(Stage::kPlanning, candidates_in(steps));
  const auto planner = [&, shares](int step, const StrategyCandidate& candidate) {
    const auto i = static_cast<std::size_t>(step);
    StepPlan planned = fastest_plan(works[i], candidate, plan, strategies, shares[i]);
    meter.add();
    return planned;
  };
  return Selection(steps, planner, plan.threads,
                   plan.objective.asks_load() ? ChoiceBy::kFigures : ChoiceBy::kTime);
}

/// The findings on the plans that are taken, with rapids above what they leave if they would meet it.
Findings findings_on(const Selection& selection, const ResolvedPlan& plan, const PlanResult& known) {
  PlanResult tried = known;
  certify(tried, toolpath_of(selection, plan, false), plan);
  if (tried.findings.all.rapid_in_material > 0) {
    tried = known;
    certify(tried, toolpath_of(selection, plan, true), plan);
  }
  return std::move(tried.findings);
}

/// Ranks the plans of every step by the figures of their certificates. In each of several programs each step is cut
/// by its next plan; the figures of a step are those of its feature in that program, in which earlier steps are
/// cut by their own plan of this number. Cost: one certificate for each plan of the step with the most.
void rank_by_figures(Selection& selection, const ResolvedPlan& plan, const PlanResult& known) {
  std::vector<std::vector<std::optional<Figures>>> found(selection.steps());
  std::size_t most = 0;
  for (std::size_t step = 0; step < selection.steps(); ++step) {
    found[step].resize(selection.plans(step));
    most = std::max(most, selection.plans(step));
  }
  if (most < 2) return;
  for (std::size_t k = 0; k < most; ++k) {
    throw_if_cancelled(plan.cancel);
    selection.take(k);
    for (const FeatureFindings& feature : findings_on(selection, plan, known).features) {
      if (feature.workingstep < 0) continue;
      auto& of_step = found[static_cast<std::size_t>(feature.workingstep)];
      if (k < of_step.size()) of_step[k] = feature.figures;
    }
  }
  for (std::size_t step = 0; step < selection.steps(); ++step) {
    std::vector<const Figures*> figures;
    for (const auto& one : found[step]) figures.push_back(one ? &*one : nullptr);
    if (figures.size() > 1) selection.rank(step, costs_of(plan.objective, figures));
  }
  selection.take(0);
}

/// The toolpath of the chosen plans, written, read back and checked; others are chosen until the program is clean or
/// no plan is left. Nothing if shortened passes do not make it clean.
std::optional<Toolpath> certified_toolpath(Selection& selection, const ResolvedPlan& plan,
                                           PlanResult& result) {
  Toolpath toolpath;
  bool over_rests = false;
  do {
    throw_if_cancelled(plan.cancel);
    toolpath = toolpath_of(selection, plan, over_rests);
    certify(result, toolpath, plan);
    if (selection.has_shortened() && verdict_of(result.findings) == Verdict::kFaulty) return std::nullopt;
  } while (begin_to_go_over_rests(over_rests, result) || retry_unclean(selection, plan, result));
  return toolpath;
}

/// What is tried in planning a part.
struct Trial {
  std::vector<double> reserve_shares;  ///< see step_works()
  bool loses_air_cuts = true;          ///< passes may go without what cuts nothing
  /// Heights, mm, by workingstep: layers as high or higher are known to meet no material. Empty: of none.
  std::vector<double> nothing_down_to = {};
};

/// The work of every workingstep for a trial.
std::vector<StepWork> works_of(const ResolvedPlan& plan, const Trial& trial) {
  std::vector<StepWork> works = step_works(plan, trial.reserve_shares);
  if (!trial.loses_air_cuts)
    for (StepWork& work : works) work.stands_alone = false;
  for (std::size_t i = 0; i < trial.nothing_down_to.size(); ++i)
    std::erase_if(works[i].layers, [&](const LayerLeft& one) {
      return one.layer.z >= trial.nothing_down_to[i] - kRoundingMm;
    });
  return works;
}

/// Every workingstep planned, and the program of the chosen plans certified.
class CertifiedPlan {
 public:
  /// `known`: what is said of the part before planning.
  CertifiedPlan(const ResolvedPlan& plan, const Trial& trial, const StrategyTable& strategies,
                ProgressMeter& meter, const PlanResult& known)
      : works(works_of(plan, trial)),
        selection(planned_selection(works, plan, strategies, meter)),
        result(known) {
    report_what_does_not_fit(result.part, selection, works, plan);
    if (plan.objective.asks_load()) rank_by_figures(selection, plan, result);
    toolpath = certified_toolpath(selection, plan, result);
  }
  CertifiedPlan(const CertifiedPlan&) = delete;
  CertifiedPlan& operator=(const CertifiedPlan&) = delete;

  const std::vector<StepWork> works;
  Selection selection;
  PlanResult result;
  std::optional<Toolpath> toolpath;  ///< absent: it has to be planned with the passes as they are
};

/// Shares of the stock kept for the rounding of digits with which a workingstep is tried: the more is kept, the wider a strip stays
/// in places that narrow down to the width of the cutter. The certificate decides which plan is right.
constexpr double kReserveShares[] = {1, 0.5, 0.2};
/// mm of a strip in a narrowing place by 1 mm of stock kept on both of its walls, where these meet at 10 degrees.
constexpr double kStripByReserve = 12;

/// Gives `share` to every workingstep on a feature where stock kept for the rounding of digits may be what leaves material uncut.
/// False if there is none.
bool lower_reserves(double share, const Findings& findings, const ResolvedPlan& plan,
                    std::vector<double>& reserve_shares) {
  if (reserve_for_digits(plan) <= 0) return false;
  const double widest = 2 * plan.tol.uncut + kStripByReserve * reserve_for_digits(plan);
  bool lowered = false;
  for (const FeatureFindings& step : findings.features) {
    if (step.workingstep < 0) continue;
    if (std::none_of(findings.faults.begin(), findings.faults.end(), [&](const Fault& fault) {
          return fault.kind == FaultKind::kUncut && fault.feature == step.name && fault.size <= widest;
        }))
      continue;
    reserve_shares[static_cast<std::size_t>(step.workingstep)] = share;
    lowered = true;
  }
  return lowered;
}

/// The certified plan of a trial. Where its passes without what cuts nothing do not make it clean, the trial has them as they are from then on.
std::unique_ptr<CertifiedPlan> certified_trial(Trial& trial, const ResolvedPlan& plan,
                                               const StrategyTable& strategies, ProgressMeter& meter,
                                               const PlanResult& known) {
  auto certified = std::make_unique<CertifiedPlan>(plan, trial, strategies, meter, known);
  if (certified->toolpath) return certified;
  trial.loses_air_cuts = false;
  return std::make_unique<CertifiedPlan>(plan, trial, strategies, meter, known);
}

/// What stands over a step is not known before planning where published grids have been cut: its layers begin as high as anything
/// may stand. Heights, by workingstep, down to which they then met nothing; empty if all layers of all steps have met something.
std::vector<double> heights_of_nothing(const Findings& findings, const ResolvedPlan& plan) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::vector<double> heights(plan.part.workplan.size(), kNone);
  bool any = false;
  for (const FeatureFindings& step : findings.features) {
    if (step.workingstep < 0 || !plan.steps[static_cast<std::size_t>(step.workingstep)].published_grid)
      continue;
    for (std::size_t i = 0; i + 1 < step.layers.size(); ++i) {
      if (step.layers[i].figures.max_axial_mm > kRoundingMm) break;
      heights[static_cast<std::size_t>(step.workingstep)] = step.layers[i].z;
      any = true;
    }
  }
  return any ? heights : std::vector<double>();
}

/// The plan without layers above all that its published grids meet; nothing if there are none, or if it is not better.
std::unique_ptr<CertifiedPlan> without_layers_above(const CertifiedPlan& found, Trial trial,
                                                    const ResolvedPlan& plan, const StrategyTable& strategies,
                                                    ProgressMeter& meter, const PlanResult& known) {
  trial.nothing_down_to = heights_of_nothing(found.result.findings, plan);
  if (trial.nothing_down_to.empty()) return nullptr;
  auto shorter = certified_trial(trial, plan, strategies, meter, known);
  const Findings &now = shorter->result.findings, &before = found.result.findings;
  const bool is_better = now.faults.size() <= before.faults.size() &&
                         now.all.rapid_in_material <= before.all.rapid_in_material &&
                         now.all.max_axial_mm <= before.all.max_axial_mm + kRoundingMm &&
                         now.all.time_s < before.all.time_s;
  return is_better ? std::move(shorter) : nullptr;
}

/// The plan with all of that stock; where this leaves material uncut, the one with the fewest faults of those with less stock
/// there.
std::unique_ptr<CertifiedPlan> certified_plan(const ResolvedPlan& plan, const StrategyTable& strategies,
                                              ProgressMeter& meter, const PlanResult& known) {
  std::unique_ptr<CertifiedPlan> best;
  Trial trial{std::vector<double>(plan.part.workplan.size(), 1)};
  for (const double share : kReserveShares) {
    if (best && !lower_reserves(share, best->result.findings, plan, trial.reserve_shares)) break;
    auto next = certified_trial(trial, plan, strategies, meter, known);
    const auto faults = [](const CertifiedPlan& one) { return one.result.findings.faults.size(); };
    if (!best || faults(*next) < faults(*best)) best = std::move(next);
  }
  if (auto shorter = without_layers_above(*best, trial, plan, strategies, meter, known))
    best = std::move(shorter);
  return best;
}

}  // namespace

void complete_verdict(const Toolpath& toolpath, const ResolvedPlan& plan, PlanResult& result) {
  add_conditions_of_part(result.part, toolpath, plan, result.findings);
  add_not_machined(result.part.diagnostics, result.findings);
  tell_corner_tolerances(toolpath, plan, result);
  result.margin = margin_asked({result.part, result.toolpath, result.control}, plan, result.findings);
  sign(result, toolpath, plan);
}

PlanResult plan_one_part(const Part& part, const PlanOptions& options) {
  const KeptClearances kept;
  const StrategyTable& strategies = strategies_of(options);
  const ResolvedPlan plan = resolve::resolve_possible(part, options, strategies);
  PlanResult result;
  result.part = plan.part;
  result.values = plan.values;
  result.earlier = plan.earlier;
  look_at_what_is_asked(plan, options, result.part);
  ProgressMeter meter(options.progress, options.cancel);
  const auto certified = certified_plan(plan, strategies, meter, result);
  const Selection& selection = certified->selection;
  Toolpath toolpath = *std::move(certified->toolpath);
  result = std::move(certified->result);
  refuse_exceeded_engagement(result, plan, options);
  complete_verdict(toolpath, plan, result);
  explain_rounded_places(result, plan);
  report_notes(selection, certified->works, plan, result.part);
  result.contours = contours_of(toolpath, plan);
  report_rho(result.contours, plan, result.part);
  result.selections = selection.selections();
  refuse_idle_options(result, toolpath, plan, options);
  result.planned = std::move(toolpath);
  return result;
}

}  // namespace clearcut::pipeline
