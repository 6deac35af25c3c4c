// Several strategies for every workingstep, of which the fastest that is certified clean is kept.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "model/contest.h"
#include "model/move.h"
#include "pipeline/strategies.h"

namespace clearcut::pipeline {

/// What one strategy made of one workingstep.
struct StepPlan {
  Section section;  ///< without moves where the cutter does not fit
  double time_s = std::numeric_limits<double>::infinity();
  // What bounds other strategies, summed over the layers:
  double reached_mm2 = 0;   ///< area of what the cutter can clear, at least
  double legal_rim_mm = 0;  ///< length of its boundary
  std::size_t edges = 0;    ///< of the largest layer's boundary
  bool pocket = true;       ///< closed all round
  bool rest = false;        ///< cleared by others around it
  bool hole = false;        ///< a round hole or a profile: made without any strategy
};

/// A workingstep with its tool and feed, as far as bounds need them.
struct ChoiceStep {
  std::string feature;
  int workingstep = 0;
  double tool_radius = 0;
  MmPerMin feed;
};

using StepPlanner = std::function<StepPlan(int workingstep, const Attempt& attempt)>;

/// The plans of all workingsteps. What is chosen depends on the plans alone, not on clocks or threads.
class Choice {
 public:
  /// Plans the first two strategies of `attempts` everywhere, then those others that may be faster by their least
  /// length and are worth the effort; all in parallel. Throws what the planner throws for the first strategy.
  Choice(std::vector<ChoiceStep> steps, Attempts attempts, StepPlanner planner,
         const resolve::PlanOptions& options);

  const Section& section(std::size_t step) const;
  /// Takes the next best plan after one that was not certified clean: a slower one, else a fallback. False when
  /// nothing is left, and the last plan stays.
  bool next(std::size_t step);
  const Attempt& attempt(std::size_t step) const;
  /// Names of strategies whose planning took too much work.
  std::vector<std::string> left_out(std::size_t step) const;
  std::vector<Contest> contests() const;

 private:
  struct Try {
    Attempt attempt;
    StepPlan plan;
    double least_s = 0;
    Outcome outcome = Outcome::kNotTried;
  };
  struct Candidates {
    std::vector<Try> tries;  ///< planned ones first, fastest first
    std::size_t at = 0;
    std::size_t planned = 0;
    std::size_t fallbacks = 0;  ///< used
  };
  void plan_first(const resolve::PlanOptions& options);
  void plan_others(const resolve::PlanOptions& options);
  void sort(Candidates& candidates) const;
  void plan_into(std::size_t step, Try& one) const;

  std::vector<ChoiceStep> steps_;
  Attempts attempts_;
  StepPlanner planner_;
  std::vector<Candidates> candidates_;
};

}  // namespace clearcut::pipeline
