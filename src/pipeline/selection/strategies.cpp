#include "pipeline/selection/strategies.h"

#include "pipeline/steps/certify.h"
#include "pipeline/tour/tour_solver.h"
#include "plan/adaptive/adaptive.h"
#include "plan/contour/contour.h"
#include "plan/cover/plan_cover.h"
#include "plan/spiral/spiral.h"
#include "plan/tour/tour.h"
#include "plan/zigzag/zigzag.h"
#include "post/post.h"

namespace clearcut::pipeline {
namespace {

plan::tour::TourSolver solver_for(const StrategyRequest& request) {
  return tour_solver(request.plan, request.step, request.objective(), request.briefly);
}

plan::MachineClock clock_of(const StrategyRequest& request) {
  const Machine& machine = request.plan.machine;
  const bool is_slower = machine.max_feed && *machine.max_feed < machine.rapid;
  return {machine, request.step.feed,
          request.plan.link_feed.value_or(is_slower ? *machine.max_feed : machine.rapid),
          post::path_control_of(post_options_of(request.plan)), planner_of_control(request.plan)};
}

StrategyTable all_strategies() {
  std::vector<StrategyEntry> all{
      plan::zigzag::entry(),         plan::spiral::entry(), plan::adaptive::entry(clock_of),
      plan::tour::entry(solver_for), plan::cover::entry(),
  };
  for (StrategyEntry& entry : plan::contour::entries()) all.push_back(std::move(entry));
  return StrategyTable(std::move(all));
}

constexpr const char* kAuto = "auto";

/// The strategy by itself, beside its rivals.
StrategyCandidates candidates_of(const StrategyEntry& strategy, const Stepover& stepover) {
  return {{{&strategy, stepover, !strategy.rivals.empty() && !stepover.is_given()}}, {}};
}

/// Whether "auto" may use a strategy at all: if a direction is requested, only strategies that keep it.
bool is_usable(const StrategyEntry& strategy, const ResolvedStep& step) {
  return strategy.in_auto != AutoUse::kNever && (!step.is_direction_asked || strategy.keeps_direction);
}

/// Whether "auto" tries the strategy before any fallback: with a limit or an aim for the engagement, only strategies
/// that keep it, since the others begin with a slot.
bool is_tried(const StrategyEntry& strategy, const ResolvedStep& step, const ResolvedPlan& plan) {
  // Figures of load decide themselves whether an aim pays.
  const bool keeps = plan.engagement_deg || (step.aimed_engagement_deg && !plan.objective.asks_load());
  return is_usable(strategy, step) && (!keeps || strategy.limits_engagement);
}

StrategyCandidate candidate_of(const StrategyEntry& strategy, const Stepover& stepover) {
  StrategyCandidate candidate{&strategy, strategy.takes_stepover ? stepover : Stepover{}};
  candidate.beside_rivals = !strategy.rivals.empty() && !stepover.is_given();
  candidate.briefly = strategy.in_auto == AutoUse::kBriefly;
  return candidate;
}

/// Shares of a stated limit of engagement at which cuts aim where no plan that aims at the limit was certified clean: some cuts
/// of rests exceed the limit, and with another aim the rests are in other places.
constexpr double kLimitShares[] = {0.9, 0.8, 0.65};

/// With a stated limit of engagement fallbacks keep it, too: without any for strategies that begin with a slot.
std::vector<StrategyCandidate> fallbacks_within_limit(const StrategyEntry& strategy,
                                                      const Stepover& stepover) {
  std::vector<StrategyCandidate> fallbacks;
  if (!strategy.limits_engagement) return fallbacks;
  for (const double share : kLimitShares) {
    fallbacks.push_back(candidate_of(strategy, stepover));
    fallbacks.back().limit_share = share;
  }
  return fallbacks;
}

std::vector<StrategyCandidate> fallbacks_by_stepover(const StrategyEntry& strategy, const Stepover& own) {
  std::vector<StrategyCandidate> fallbacks;
  for (const std::string& stepover : strategy.fallbacks)
    fallbacks.push_back({&strategy, stepover.empty() ? own : Stepover{stepover}});
  return fallbacks;
}

}  // namespace

const StrategyTable& built_in_strategies() {
  static const StrategyTable table = all_strategies();
  return table;
}

std::vector<std::string> strategy_names(const StrategyTable& table) {
  std::vector<std::string> names{kAuto};
  for (const StrategyEntry& entry : table.entries()) names.push_back(entry.name);
  return names;
}

const std::vector<std::string>& contour_method_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const StrategyEntry& entry : plan::contour::entries()) all.push_back(entry.name);
    return all;
  }();
  return names;
}

std::optional<plan::contour::StepRule> published_rule(const std::string& strategy) {
  return plan::contour::published_rule(strategy);
}

std::string description_of(const std::string& strategy, const StrategyTable& table) {
  const StrategyEntry* entry = table.find(strategy);
  return entry ? entry->description : "the fastest that certifies clean";
}

Strategy strategy_for(const StrategyCandidate& candidate, const ResolvedStep& step,
                      const ResolvedPlan& plan) {
  return candidate.strategy->make(
      {step, plan, candidate.stepover, candidate.briefly, candidate.limit_share, candidate.order});
}

namespace {

StrategyCandidates usual_candidates(const ResolvedStep& step, const ResolvedPlan& plan,
                                    const StrategyTable& table) {
  if (step.strategy) {
    StrategyCandidates stated = candidates_of(*step.strategy, step.stepover);
    if (plan.engagement_deg) stated.fallbacks = fallbacks_within_limit(*step.strategy, step.stepover);
    return stated;
  }
  StrategyCandidates candidates;
  for (const bool first : {true, false}) {
    for (const StrategyEntry& entry : table.entries()) {
      if (is_tried(entry, step, plan) && (entry.in_auto == AutoUse::kFirst) == first)
        candidates.competing.push_back(candidate_of(entry, step.stepover));
    }
  }
  for (const StrategyEntry& entry : table.entries()) {
    if (!is_usable(entry, step)) continue;
    const auto fallbacks = plan.engagement_deg ? fallbacks_within_limit(entry, step.stepover)
                                               : fallbacks_by_stepover(entry, step.stepover);
    candidates.fallbacks.insert(candidates.fallbacks.end(), fallbacks.begin(), fallbacks.end());
  }
  return candidates;
}

/// Each objective of the candidates' own searches as a candidate; no rival is taken for its time.
std::vector<StrategyCandidate> in_each_order(const std::vector<StrategyCandidate>& candidates) {
  std::vector<StrategyCandidate> all;
  for (StrategyCandidate one : candidates) {
    one.beside_rivals = false;
    if (one.strategy->orders.empty()) all.push_back(one);
    for (const ObjectiveKind order : one.strategy->orders) {
      one.order = order;
      all.push_back(one);
    }
  }
  return all;
}

}  // namespace

StrategyCandidates candidates_for(const ResolvedStep& step, const ResolvedPlan& plan,
                                  const StrategyTable& table) {
  StrategyCandidates candidates = usual_candidates(step, plan, table);
  if (!plan.objective.asks_load()) return candidates;
  return {in_each_order(candidates.competing), in_each_order(candidates.fallbacks)};
}

}  // namespace clearcut::pipeline
