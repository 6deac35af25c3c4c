// Several strategies for every workingstep, of which the fastest that is certified clean is kept.
#pragma once

#include <exception>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "model/move.h"
#include "model/results/strategy_selection.h"
#include "pipeline/selection/strategies.h"

namespace clearcut::pipeline {

/// What one strategy made of one workingstep.
struct StepPlan {
  Section section;  ///< without moves where the cutter does not fit
  double time_s = std::numeric_limits<double>::infinity();
  ClearedSize size;    ///< what bounds other strategies
  bool pocket = true;  ///< closed all round
  bool rest = false;   ///< cleared by others around it
  /// False where a rival's passes are known to leave what they could reach.
  bool leaves_nothing = true;
  bool hole = false;  ///< a round hole or a profile: made without any strategy
};

/// A workingstep with what is tried for it, its tool and feed as far as bounds need them.
struct SelectionStep {
  std::string feature;
  int workingstep = 0;
  double tool_radius = 0;
  MmPerMin feed;
  StrategyCandidates candidates;
};

using StepPlanner = std::function<StepPlan(int workingstep, const StrategyCandidate& candidate)>;

/// The plans of all workingsteps. What is chosen depends on the plans alone, not on clocks or threads.
class Selection {
 public:
  /// Plans the first two candidates of every step, then those others that may be faster by their least length and are worth
  /// the effort; all in parallel on `threads`. What finds no memory beside others is planned once more alone. Throws what the
  /// planner throws for a step's first strategy, and std::bad_alloc where no strategy of a step finds the memory.
  Selection(std::vector<SelectionStep> steps, StepPlanner planner, int threads);

  const Section& section(std::size_t step) const;
  /// Takes the next best plan after one that was not certified clean: a slower one (the strategy's own, too, where a rival's was
  /// not clean), else a fallback. False when
  /// nothing is left, and the last plan stays.
  bool next(std::size_t step);
  const StrategyCandidate& candidate(std::size_t step) const;
  /// Names of strategies whose planning took too much work.
  std::vector<std::string> left_out(std::size_t step) const { return names_of(step, Outcome::kTooMuchWork); }
  /// The same for memory.
  std::vector<std::string> beyond_memory(std::size_t step) const {
    return names_of(step, Outcome::kTooMuchMemory);
  }
  std::vector<StrategySelection> selections() const;

 private:
  struct PlannedCandidate {
    StrategyCandidate candidate;
    StepPlan plan;
    double least_s = 0;
    Outcome outcome = Outcome::kNotTried;
    std::exception_ptr without_memory{};  ///< what was thrown where it found none
  };
  static bool is_planned(const PlannedCandidate& one) { return !one.plan.section.moves.empty(); }

  struct RankedCandidates {
    std::vector<PlannedCandidate> all;  ///< planned ones first, fastest first
    std::size_t at = 0;
    std::size_t planned = 0;
    std::size_t fallbacks = 0;  ///< used
  };
  /// Places of candidates: step, candidate.
  using Places = std::vector<std::pair<std::size_t, std::size_t>>;

  std::vector<std::string> names_of(std::size_t step, Outcome outcome) const;
  void plan_first();
  void plan_others();
  void plan_instead();
  void rate_others(std::size_t step, Places& work);
  void plan_all(const Places& work);
  void sort(RankedCandidates& ranked) const;
  void plan_without_rivals(std::size_t step);
  void plan_into(std::size_t step, PlannedCandidate& one) const;
  static void throw_without_memory(const RankedCandidates& ranked);

  std::vector<SelectionStep> steps_;
  StepPlanner planner_;
  int threads_;
  std::vector<RankedCandidates> ranked_;
};

}  // namespace clearcut::pipeline
