#include "pipeline/selection/choice.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/work_budget.h"

namespace clearcut::pipeline {
namespace {

/// So many of the attempts are planned in any case.
constexpr std::size_t kFirst = 2;
/// mm. What a strategy has to travel at least, from the area that can be cleared (SPEC F6).
double least_way(const StrategyEntry& strategy, const ClearedSize& size, double radius) {
  return strategy.least_length ? strategy.least_length(size, radius) : size.reached_mm2 / (2 * radius);
}

/// Edges of an outline up to which planning once more is not felt.
constexpr double kFewEdges = 150;

/// Whether planning a strategy that may win is worth its effort: the more edges, the more room it must have between its
/// least time and the best known.
bool is_worthwhile(const StrategyEntry& strategy, const ClearedSize& known, double least_s, double best_s,
                   double radius) {
  if (strategy.is_small_enough && !strategy.is_small_enough(known, radius)) return false;
  const double size = std::pow(std::max(1.0, static_cast<double>(known.edges) / kFewEdges), 0.125);
  return best_s > strategy.margin * size * least_s;
}

template <typename Work>
void in_parallel(std::size_t count, int threads, Work&& work) {
  on_threads(threads, [&] { parallel_for(std::size_t{0}, count, work); });
}

}  // namespace

Choice::Choice(std::vector<ChoiceStep> steps, StepPlanner planner, int threads)
    : steps_(std::move(steps)), planner_(std::move(planner)), threads_(threads), candidates_(steps_.size()) {
  for (std::size_t step = 0; step < steps_.size(); ++step) {
    for (const auto& attempt : steps_[step].attempts.contest)
      candidates_[step].tries.push_back({attempt, {}, 0, Outcome::kNotTried});
  }
  plan_first();
  plan_others();
  for (auto& candidates : candidates_) sort(candidates);
}

/// Strategies but the first may refuse what was asked for: then they are not in the contest.
void Choice::plan_into(std::size_t step, Try& one) const {
  const bool first = one.attempt.strategy == steps_[step].attempts.contest.front().strategy;
  try {
    one.plan = planner_(steps_[step].workingstep, one.attempt);
    if (!one.plan.section.moves.empty()) one.outcome = Outcome::kOutrun;
  } catch (const InputError&) {
    if (first) throw;
  } catch (const OutOfWork&) {
    one.plan = {};
    one.outcome = Outcome::kTooMuchWork;
  }
}

void Choice::plan_first() {
  std::vector<std::pair<std::size_t, std::size_t>> work;
  for (std::size_t step = 0; step < steps_.size(); ++step) {
    for (std::size_t k = 0; k < std::min(kFirst, candidates_[step].tries.size()); ++k)
      work.emplace_back(step, k);
  }
  in_parallel(work.size(), threads_, [&](std::size_t i) {
    plan_into(work[i].first, candidates_[work[i].first].tries[work[i].second]);
  });
}

/// Adds the attempts of a step that may be faster than the first ones to `work`.
void Choice::rate_others(std::size_t step, std::vector<std::pair<std::size_t, std::size_t>>& work) {
  auto& tries = candidates_[step].tries;
  const StepPlan& known = tries.front().plan;
  const double radius = steps_[step].tool_radius;
  if (known.hole || known.rest || known.section.moves.empty()) return;
  // Where the cutter has hardly room to move there is nothing to choose.
  if (known.size.reached_mm2 < 8 * radius * radius) return;
  double best = known.time_s;
  for (std::size_t k = 1; k < std::min(kFirst, tries.size()); ++k)
    best = std::min(best, tries[k].plan.time_s);
  for (std::size_t k = kFirst; k < tries.size(); ++k) {
    const StrategyEntry& strategy = *tries[k].attempt.strategy;
    if (!known.pocket && !strategy.tried_when_open) continue;
    tries[k].least_s = least_way(strategy, known.size, radius) / steps_[step].feed.mm_per_s();
    if (tries[k].least_s >= best) {
      tries[k].outcome = Outcome::kCannotWin;
    } else if (is_worthwhile(strategy, known.size, tries[k].least_s, best, radius)) {
      work.emplace_back(step, k);
    }
  }
}

void Choice::plan_others() {
  std::vector<std::pair<std::size_t, std::size_t>> work;
  for (std::size_t step = 0; step < steps_.size(); ++step) rate_others(step, work);
  in_parallel(work.size(), threads_, [&](std::size_t i) {
    plan_into(work[i].first, candidates_[work[i].first].tries[work[i].second]);
  });
}

/// Holes come out the same whatever the strategy, so the first stays in front.
void Choice::sort(Candidates& candidates) const {
  auto& tries = candidates.tries;
  if (tries.front().plan.hole) tries.resize(1);
  std::stable_sort(tries.begin(), tries.end(), [](const Try& a, const Try& b) {
    const bool a_planned = !a.plan.section.moves.empty(), b_planned = !b.plan.section.moves.empty();
    return a_planned != b_planned ? a_planned : a_planned && a.plan.time_s < b.plan.time_s;
  });
  candidates.planned = static_cast<std::size_t>(std::count_if(
      tries.begin(), tries.end(), [](const Try& one) { return !one.plan.section.moves.empty(); }));
  if (candidates.planned > 0) tries.front().outcome = Outcome::kKept;
}

const Section& Choice::section(std::size_t step) const {
  return candidates_[step].tries[candidates_[step].at].plan.section;
}

const Attempt& Choice::attempt(std::size_t step) const {
  return candidates_[step].tries[candidates_[step].at].attempt;
}

std::vector<std::string> Choice::left_out(std::size_t step) const {
  std::vector<std::string> names;
  for (const auto& one : candidates_[step].tries) {
    if (one.outcome == Outcome::kTooMuchWork) names.push_back(one.attempt.strategy->name);
  }
  return names;
}

bool Choice::next(std::size_t step) {
  auto& candidates = candidates_[step];
  const auto& fallbacks = steps_[step].attempts.fallbacks;
  if (candidates.planned == 0 || candidates.tries[candidates.at].plan.hole) return false;
  if (candidates.at + 1 >= candidates.planned) {
    if (candidates.fallbacks == fallbacks.size()) return false;
    Try fallback{fallbacks[candidates.fallbacks++], {}, 0, Outcome::kNotTried};
    plan_into(step, fallback);
    const auto place = candidates.tries.begin() + static_cast<std::ptrdiff_t>(candidates.planned++);
    candidates.tries.insert(place, std::move(fallback));
  }
  candidates.tries[candidates.at].outcome = Outcome::kNotClean;
  candidates.tries[++candidates.at].outcome = Outcome::kKept;
  return true;
}

std::vector<Contest> Choice::contests() const {
  std::vector<Contest> contests;
  for (std::size_t step = 0; step < steps_.size(); ++step) {
    Contest contest{steps_[step].feature, steps_[step].workingstep, {}};
    for (const auto& one : candidates_[step].tries) {
      const bool planned = !one.plan.section.moves.empty();
      contest.contestants.push_back({one.attempt.strategy->name, one.attempt.stepover.text, one.outcome,
                                     planned ? one.plan.time_s : 0,
                                     planned ? feed_length(one.plan.section) : 0, one.least_s});
    }
    contests.push_back(std::move(contest));
  }
  return contests;
}

}  // namespace clearcut::pipeline
