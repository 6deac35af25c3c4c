#include "pipeline/selection/selection.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "base/elementary.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/work_budget.h"

namespace clearcut::pipeline {
namespace {

/// Number of candidates planned in any case.
constexpr std::size_t kFirst = 2;
/// mm. Least length of a strategy's path, from the area that can be cleared.
double least_way(const StrategyEntry& strategy, const ClearedSize& size, double radius) {
  return strategy.least_length ? strategy.least_length(size, radius) : size.reached_mm2 / (2 * radius);
}

/// Number of edges of an outline up to which a further plan takes no noticeable time.
constexpr double kFewEdges = 150;

/// Whether planning a possibly winning strategy is worth the effort: with more edges, its least time must be further
/// below the best known time.
bool is_worthwhile(const StrategyEntry& strategy, const ClearedSize& known, double least_s, double best_s,
                   double radius) {
  if (strategy.is_small_enough && !strategy.is_small_enough(known, radius)) return false;
  const double size = base::pow(std::max(1.0, static_cast<double>(known.edges) / kFewEdges), 0.125);
  return best_s > strategy.margin * size * least_s;
}

template <typename Work>
void in_parallel(std::size_t count, int threads, Work&& work) {
  on_threads(threads, [&] { parallel_for(std::size_t{0}, count, work); });
}

}  // namespace

Selection::Selection(std::vector<SelectionStep> steps, StepPlanner planner, int threads, ChoiceBy choice)
    : steps_(std::move(steps)),
      planner_(std::move(planner)),
      threads_(threads),
      choice_(choice),
      ranked_(steps_.size()) {
  for (std::size_t step = 0; step < steps_.size(); ++step) {
    for (const auto& candidate : steps_[step].candidates.competing)
      ranked_[step].all.push_back({candidate, {}, 0, Outcome::kNotTried, {}, {}});
  }
  plan_first();
  plan_others();
  plan_instead();
  for (auto& ranked : ranked_) sort(ranked);
}

/// Strategies except the first may refuse the request: they are then not in the selection.
void Selection::plan_into(std::size_t step, PlannedCandidate& one) const {
  const bool first = one.candidate.strategy == steps_[step].candidates.competing.front().strategy;
  one.outcome = Outcome::kNotTried;
  one.without_memory = nullptr;
  try {
    one.plan = planner_(steps_[step].workingstep, one.candidate);
    if (!one.plan.section.moves.empty()) one.outcome = Outcome::kOutrun;
  } catch (const InputError&) {
    if (first) throw;
  } catch (const OutOfWork&) {
    one.plan = {};
    one.outcome = Outcome::kTooMuchWork;
  } catch (const std::bad_alloc&) {
    one.plan = {};
    one.outcome = Outcome::kTooMuchMemory;
    one.without_memory = std::current_exception();
  }
}

/// Memory used by other candidates may be free now, so candidates that failed for lack of memory are planned again by
/// themselves: the set of left-out candidates does not depend on threads.
void Selection::plan_all(const Places& work) {
  const auto plan = [&](std::size_t i) {
    plan_into(work[i].first, ranked_[work[i].first].all[work[i].second]);
  };
  in_parallel(work.size(), threads_, plan);
  for (std::size_t i = 0; i < work.size(); ++i) {
    if (ranked_[work[i].first].all[work[i].second].outcome == Outcome::kTooMuchMemory) plan(i);
  }
}

/// If no plan was made for lack of memory the caller must be informed.
void Selection::throw_without_memory(const RankedCandidates& ranked) {
  if (std::any_of(ranked.all.begin(), ranked.all.end(), is_planned)) return;
  for (const PlannedCandidate& one : ranked.all) {
    if (one.without_memory) std::rethrow_exception(one.without_memory);
  }
}

void Selection::plan_first() {
  Places work;
  for (std::size_t step = 0; step < steps_.size(); ++step) {
    for (std::size_t k = 0; k < std::min(kFirst, ranked_[step].all.size()); ++k) work.emplace_back(step, k);
  }
  plan_all(work);
}

/// Adds the candidates of a step possibly faster than the first ones to `work`.
void Selection::rate_others(std::size_t step, Places& work) {
  auto& all = ranked_[step].all;
  const StepPlan& known = all.front().plan;
  const double radius = steps_[step].tool_radius;
  if (known.hole || known.rest || known.section.moves.empty()) return;
  // If the cutter has hardly room to move there is no choice.
  if (known.size.reached_mm2 < 8 * radius * radius) return;
  double best = known.time_s;
  for (std::size_t k = 1; k < std::min(kFirst, all.size()); ++k) best = std::min(best, all[k].plan.time_s);
  for (std::size_t k = kFirst; k < all.size(); ++k) {
    const StrategyEntry& strategy = *all[k].candidate.strategy;
    if (!known.pocket && !strategy.tried_when_open) continue;
    if (choice_ == ChoiceBy::kFigures) {
      if (!strategy.is_small_enough || strategy.is_small_enough(known.size, radius))
        work.emplace_back(step, k);
      continue;
    }
    all[k].least_s = least_way(strategy, known.size, radius) / steps_[step].feed.mm_per_s();
    if (all[k].least_s >= best) {
      all[k].outcome = Outcome::kCannotWin;
    } else if (is_worthwhile(strategy, known.size, all[k].least_s, best, radius)) {
      work.emplace_back(step, k);
    }
  }
}

void Selection::plan_others() {
  Places work;
  for (std::size_t step = 0; step < steps_.size(); ++step) rate_others(step, work);
  plan_all(work);
}

/// If all candidates took too much work or memory a fallback is used.
void Selection::plan_instead() {
  in_parallel(steps_.size(), threads_, [&](std::size_t step) {
    auto& ranked = ranked_[step];
    const auto& fallbacks = steps_[step].candidates.fallbacks;
    if (std::any_of(ranked.all.begin(), ranked.all.end(), is_planned) ||
        std::none_of(ranked.all.begin(), ranked.all.end(), [](const PlannedCandidate& one) {
          return one.outcome == Outcome::kTooMuchWork || one.outcome == Outcome::kTooMuchMemory;
        }))
      return;
    while (ranked.fallbacks < fallbacks.size() && !is_planned(ranked.all.back())) {
      ranked.all.push_back({fallbacks[ranked.fallbacks++], {}, 0, Outcome::kNotTried, {}, {}});
      plan_into(step, ranked.all.back());
    }
  });
  for (const RankedCandidates& ranked : ranked_) throw_without_memory(ranked);
}

/// Holes are the same for any strategy, so the first candidate stays in front.
void Selection::sort(RankedCandidates& ranked) const {
  auto& all = ranked.all;
  if (all.front().plan.hole) all.resize(1);
  std::stable_sort(all.begin(), all.end(), [](const PlannedCandidate& a, const PlannedCandidate& b) {
    const bool a_planned = is_planned(a), b_planned = is_planned(b);
    return a_planned != b_planned ? a_planned : a_planned && a.plan.time_s < b.plan.time_s;
  });
  ranked.planned = static_cast<std::size_t>(std::count_if(all.begin(), all.end(), is_planned));
  if (ranked.planned > 0) all.front().outcome = Outcome::kKept;
}

void Selection::take(std::size_t k) {
  for (RankedCandidates& ranked : ranked_) {
    if (ranked.planned > 0) ranked.at = std::min(k, ranked.planned - 1);
  }
}

void Selection::rank(std::size_t step, const std::vector<double>& costs) {
  RankedCandidates& ranked = ranked_[step];
  for (std::size_t k = 0; k < costs.size(); ++k) {
    PlannedCandidate& one = ranked.all[k];
    if (std::isfinite(costs[k])) one.cost = costs[k];
    one.outcome = one.cost ? Outcome::kWorse : Outcome::kNotClean;
  }
  const auto end = ranked.all.begin() + static_cast<std::ptrdiff_t>(ranked.planned);
  std::stable_sort(ranked.all.begin(), end, [](const PlannedCandidate& a, const PlannedCandidate& b) {
    return a.cost && (!b.cost || *a.cost < *b.cost);
  });
  ranked.at = 0;
  if (ranked.planned > 0) ranked.all.front().outcome = Outcome::kKept;
}

const Section& Selection::section(std::size_t step) const {
  return ranked_[step].all[ranked_[step].at].plan.section;
}

bool Selection::has_shortened() const {
  return std::any_of(ranked_.begin(), ranked_.end(), [](const RankedCandidates& ranked) {
    return !ranked.all.empty() && ranked.all[ranked.at].plan.is_shortened;
  });
}

const StrategyCandidate& Selection::candidate(std::size_t step) const {
  return ranked_[step].all[ranked_[step].at].candidate;
}

std::vector<std::string> Selection::names_of(std::size_t step, Outcome outcome) const {
  std::vector<std::string> names;
  for (const auto& one : ranked_[step].all) {
    if (one.outcome == outcome) names.push_back(one.candidate.strategy->name);
  }
  return names;
}

/// A failed rival's plan is no evidence against the strategy itself: the strategy's own plan is made, and ranked
/// among the remaining ones.
void Selection::plan_without_rivals(std::size_t step) {
  auto& ranked = ranked_[step];
  PlannedCandidate own{ranked.all[ranked.at].candidate, {}, 0, Outcome::kNotTried, {}, {}};
  own.candidate.beside_rivals = false;
  plan_into(step, own);
  if (own.plan.section.moves.empty()) return;
  const auto left = ranked.all.begin() + static_cast<std::ptrdiff_t>(ranked.at + 1);
  const auto end = ranked.all.begin() + static_cast<std::ptrdiff_t>(ranked.planned++);
  const auto place = std::find_if(
      left, end, [&](const PlannedCandidate& other) { return other.plan.time_s > own.plan.time_s; });
  ranked.all.insert(place, std::move(own));
}

bool Selection::next(std::size_t step) {
  auto& ranked = ranked_[step];
  const auto& fallbacks = steps_[step].candidates.fallbacks;
  if (ranked.planned == 0 || ranked.all[ranked.at].plan.hole) return false;
  if (ranked.all[ranked.at].candidate.beside_rivals) plan_without_rivals(step);
  while (ranked.at + 1 >= ranked.planned) {
    if (ranked.fallbacks == fallbacks.size()) return false;
    PlannedCandidate fallback{fallbacks[ranked.fallbacks++], {}, 0, Outcome::kNotTried, {}, {}};
    plan_into(step, fallback);
    const auto place = ranked.all.begin() + static_cast<std::ptrdiff_t>(ranked.planned);
    if (is_planned(fallback)) ++ranked.planned;
    ranked.all.insert(place, std::move(fallback));
  }
  ranked.all[ranked.at].outcome = Outcome::kNotClean;
  ranked.all[++ranked.at].outcome = Outcome::kKept;
  return true;
}

std::vector<StrategySelection> Selection::selections() const {
  std::vector<StrategySelection> selections;
  for (std::size_t step = 0; step < steps_.size(); ++step) {
    StrategySelection selection{
        steps_[step].feature, steps_[step].workingstep, {}, ranked_[step].all.front().plan.hole};
    for (const auto& one : ranked_[step].all) {
      const bool planned = is_planned(one);
      selection.candidates.push_back({one.candidate.strategy->name, one.candidate.stepover.text, one.outcome,
                                      planned ? one.plan.time_s : 0,
                                      planned ? feed_length(one.plan.section) : 0, one.least_s,
                                      one.candidate.order ? name_of(*one.candidate.order) : "", one.cost});
    }
    selections.push_back(std::move(selection));
  }
  return selections;
}

}  // namespace clearcut::pipeline
