#include "pipeline/choice.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/work_budget.h"
#include "plan/adaptive/adaptive.h"
#include "plan/spiral/turn.h"
#include "plan/tour/tour.h"

namespace clearcut::pipeline {
namespace {

/// So many of the attempts are planned in any case.
constexpr std::size_t kFirst = 2;
/// mm. What a strategy has to travel at least, from the area that can be cleared (SPEC F6).
double least_way(const std::string& strategy, const StepPlan& known, double radius) {
  const double plain = known.reached_mm2 / (2 * radius);
  if (strategy == "spiral") return plain + plan::spiral::kSpiralFall * known.legal_rim_mm / 2;
  if (strategy == "adaptive") {
    return known.reached_mm2 /
           (radius * (1 - std::cos(plan::adaptive::AdaptiveOptions{}.engagement.radians())));
  }
  return plain;
}

/// Edges of an outline up to which planning once more is not felt.
constexpr double kFewEdges = 150;
/// Points of a grid above which no tour is tried.
constexpr double kMostPoints = 1000;

/// Whether planning a strategy that may win is worth its effort: the more edges or points, the more room it must have
/// between its least time and the best known. Strategies stay that much above their least times nearly everywhere: of
/// 120 random pockets spirals by 1.17 to 2, tours by 1.37 to 3.
bool is_worthwhile(const std::string& strategy, const StepPlan& known, double least_s, double best_s,
                   double radius) {
  const double size = std::pow(std::max(1.0, static_cast<double>(known.edges) / kFewEdges), 0.125);
  if (strategy == "tour") {
    const double pitch = plan::tour::TourGridOptions{}.pitch * 2 * radius;
    return known.reached_mm2 / (pitch * pitch) <= kMostPoints && best_s > 1.35 * size * least_s;
  }
  return best_s > (strategy == "spiral" ? 1.15 : 1.0) * size * least_s;
}

template <typename Work>
void in_parallel(std::size_t count, int threads, Work&& work) {
  tbb::task_arena arena(threads);
  arena.execute([&] { parallel_for(std::size_t{0}, count, work); });
}

}  // namespace

Choice::Choice(std::vector<ChoiceStep> steps, Attempts attempts, StepPlanner planner,
               const resolve::PlanOptions& options)
    : steps_(std::move(steps)),
      attempts_(std::move(attempts)),
      planner_(std::move(planner)),
      candidates_(steps_.size()) {
  for (auto& candidates : candidates_) {
    for (const auto& attempt : attempts_.contest)
      candidates.tries.push_back({attempt, {}, 0, Outcome::kNotTried});
  }
  plan_first(options);
  plan_others(options);
  for (auto& candidates : candidates_) sort(candidates);
}

/// Strategies but the first may refuse what was asked for: then they are not in the contest.
void Choice::plan_into(std::size_t step, Try& one) const {
  const bool first = one.attempt.strategy == attempts_.contest.front().strategy;
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

void Choice::plan_first(const resolve::PlanOptions& options) {
  const std::size_t each = std::min(kFirst, attempts_.contest.size());
  in_parallel(steps_.size() * each, resolve::thread_count(options), [&](std::size_t i) {
    const std::size_t step = i / each, k = i % each;
    plan_into(step, candidates_[step].tries[k]);
  });
}

void Choice::plan_others(const resolve::PlanOptions& options) {
  std::vector<std::pair<std::size_t, std::size_t>> work;
  for (std::size_t step = 0; step < steps_.size(); ++step) {
    auto& tries = candidates_[step].tries;
    const StepPlan& known = tries.front().plan;
    if (known.hole || known.rest || known.section.moves.empty()) continue;
    // Where the cutter has hardly room to move there is nothing to choose.
    if (known.reached_mm2 < 8 * steps_[step].tool_radius * steps_[step].tool_radius) continue;
    double best = known.time_s;
    for (std::size_t k = 1; k < std::min(kFirst, tries.size()); ++k)
      best = std::min(best, tries[k].plan.time_s);
    for (std::size_t k = kFirst; k < tries.size(); ++k) {
      if (!known.pocket && tries[k].attempt.strategy != "tour") continue;
      const double way = least_way(tries[k].attempt.strategy, known, steps_[step].tool_radius);
      tries[k].least_s = way / steps_[step].feed.mm_per_s();
      if (tries[k].least_s >= best) {
        tries[k].outcome = Outcome::kCannotWin;
      } else if (is_worthwhile(tries[k].attempt.strategy, known, tries[k].least_s, best,
                               steps_[step].tool_radius)) {
        work.emplace_back(step, k);
      }
    }
  }
  in_parallel(work.size(), resolve::thread_count(options), [&](std::size_t i) {
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
    if (one.outcome == Outcome::kTooMuchWork) names.push_back(one.attempt.strategy);
  }
  return names;
}

bool Choice::next(std::size_t step) {
  auto& candidates = candidates_[step];
  if (candidates.planned == 0 || candidates.tries[candidates.at].plan.hole) return false;
  if (candidates.at + 1 >= candidates.planned) {
    if (candidates.fallbacks == attempts_.fallbacks.size()) return false;
    Try fallback{attempts_.fallbacks[candidates.fallbacks++], {}, 0, Outcome::kNotTried};
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
      contest.contestants.push_back({one.attempt.strategy, one.attempt.stepover.value_or(""), one.outcome,
                                     planned ? one.plan.time_s : 0,
                                     planned ? feed_length(one.plan.section) : 0, one.least_s});
    }
    contests.push_back(std::move(contest));
  }
  return contests;
}

}  // namespace clearcut::pipeline
