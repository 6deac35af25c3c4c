#include "pipeline/planning/planned_step.h"

#include <algorithm>
#include <utility>

#include "base/work_budget.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"
#include "kinematics/planner.h"
#include "pipeline/steps/certify.h"
#include "plan/common/clearing_area.h"
#include "plan/common/layers.h"
#include "plan/common/leaves_nothing.h"
#include "plan/common/walls.h"
#include "plan/profile/profile.h"
#include "post/post.h"

namespace clearcut::pipeline {
namespace {

/// mm. Areas cleared by other steps may contain residuals up to this thickness: unsuitable for rapids.
constexpr double kResidualOfOthers = 0.01;

/// Least area reached beyond the rim, as a share of its length times the radius: less is reached at corners than at
/// straight walls.
constexpr double kBeyondRim = 0.9;

/// Sizes that bound the length of any strategy, layer by layer.
class Sizes {
 public:
  explicit Sizes(const Tolerances& tol) : tol_(tol) {}

  void add(StepPlan& plan, const Layer& layer, const LayerPasses& passes) {
    double rim = 0;
    for (const auto& region : passes.legal) {
      for (const auto& edge : region.edges()) rim += edge.length();
    }
    const bool pocket = plan::closed_all_round(layer);
    plan.size.reached_mm2 += pocket ? area(passes.legal) + kBeyondRim * layer.tool_radius * rim
                                    : reached_of_open(layer, passes.legal);
    plan.size.legal_rim_mm += rim;
    plan.size.edges = std::max(plan.size.edges, edge_count(passes.legal));
    plan.pocket = plan.pocket && pocket;
  }

 private:
  /// Layers usually differ from the previous one only in height.
  double reached_of_open(const Layer& layer, const Regions& legal) {
    if (legal.empty()) return 0;
    if (!plan::same_outline(legal, legal_) || !plan::same_outline(layer.target, target_)) {
      legal_ = legal;
      target_ = layer.target;
      reached_mm2_ = area(intersect(layer.target, dilate(legal, layer.tool_radius, tol_), tol_));
    }
    return reached_mm2_;
  }

  const Tolerances& tol_;
  Regions legal_, target_;
  double reached_mm2_ = 0;
};

/// The passes of a workingstep layer by layer; the cleared size, and whether material is left, are stored in `plan`.
std::vector<LayerPasses> passes_of(const StepWork& work, const Feature& feature,
                                   const StrategyCandidate& candidate, const ResolvedPlan& job,
                                   StepPlan& plan) {
  const auto strategy = strategy_for(candidate, job.steps[static_cast<std::size_t>(work.workingstep)], job);
  std::vector<LayerPasses> passes;
  Sizes sizes(job.tol);
  for (const auto& layer : work.layers) {
    throw_if_cancelled(job.cancel);
    passes.push_back(feature.profile    ? plan::profile::plan_profile(layer.layer, *feature.profile, job.tol)
                     : layer.walls_only ? plan::plan_walls(layer.layer, job.tol)
                                        : strategy(layer.layer));
    passes.back().wall_top = work.wall_top;
    if (work.meets_others && plan.leaves_nothing && candidate.as_rival)
      plan.leaves_nothing = plan::leaves_nothing(passes.back(), layer.layer.tool_radius);
    if (layer.rest) passes.back().residual = std::max(passes.back().residual, kResidualOfOthers);
    sizes.add(plan, layer.layer, passes.back());
    plan.rest = plan.rest || layer.rest;
  }
  return passes;
}

/// s; time by the planner of the program's control.
double time_on_machine(const Section& section, const ResolvedPlan& job) {
  return kinematics::planned_time(section.moves, post::path_control_of(post_options_of(job)), job.machine,
                                  planner_of_control(job))
      .seconds();
}

/// Number of edges of an outline above which rivals are not tried: the waiting time would be noticeable.
constexpr std::size_t kMostEdgesForRivals = 400;

}  // namespace

StepPlan plan_step(const StepWork& work, const StrategyCandidate& candidate, const ResolvedPlan& job,
                   std::uint64_t most_work) {
  const ResolvedStep& step = job.steps[static_cast<std::size_t>(work.workingstep)];
  const WorkBudget budget(most_work);
  StepPlan plan;
  const auto& feature = feature_of(job.part, job.part.workplan[static_cast<std::size_t>(work.workingstep)]);
  if (work.hole) {
    plan.section = *work.hole;
    plan.hole = true;
  } else {
    const auto passes = passes_of(work, feature, candidate, job, plan);
    const EntryKind entry =
        !feature.profile && candidate.strategy->limits_engagement ? step.entry_at_limit : step.entry;
    plan.hole = feature.profile.has_value();
    plan.section = link_step(passes, work.workingstep, entry, job);
  }
  plan.time_s = time_on_machine(plan.section, job);
  return plan;
}

std::vector<SelectionStep> selection_steps(const ResolvedPlan& plan, const StrategyTable& strategies) {
  std::vector<SelectionStep> steps;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const auto& step = plan.part.workplan[i];
    steps.push_back({feature_of(plan.part, step).name, static_cast<int>(i), tool_of(plan.part, step).radius(),
                     plan.steps[i].feed, candidates_for(plan.steps[i], plan, strategies)});
  }
  return steps;
}

StepPlan fastest_plan(const StepWork& work, const StrategyCandidate& candidate, const ResolvedPlan& job,
                      const StrategyTable& strategies, std::uint64_t most_work) {
  const Part& part = job.part;
  StepPlan best = plan_step(work, candidate, job, most_work);
  const auto& feature = feature_of(part, part.workplan[static_cast<std::size_t>(work.workingstep)]);
  const bool alone =
      !candidate.beside_rivals || best.hole || edge_count(feature.allowed) > kMostEdgesForRivals;
  if (alone || best.section.moves.empty()) return best;
  for (const auto& name : candidate.strategy->rivals) {
    const StrategyEntry* rival = strategies.find(name);
    if (!rival) continue;
    try {
      StepPlan plan = plan_step(work, {rival, {}, false, false, true}, job, most_work);
      if (plan.section.moves.empty() || plan.time_s >= best.time_s || !plan.leaves_nothing) continue;
      best.section = std::move(plan.section);
      best.time_s = plan.time_s;
    } catch (const OutOfWork&) {
      continue;  // the candidate itself is kept
    }
  }
  return best;
}

}  // namespace clearcut::pipeline
