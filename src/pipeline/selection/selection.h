// Several strategies for every workingstep, of which the fastest one certified clean, or the best one by figures of
// the certificate, is kept, and rapids above material left by published methods and skipped workingsteps.
#pragma once

#include <exception>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/move.h"
#include "model/options/resolved_plan.h"
#include "model/results/strategy_selection.h"
#include "pipeline/selection/strategies.h"

namespace clearcut::pipeline {

/// The plan of one strategy for one workingstep.
struct StepPlan {
  Section section;  ///< without moves if the cutter does not fit
  double time_s = std::numeric_limits<double>::infinity();
  ClearedSize size;    ///< bounds for other strategies
  bool pocket = true;  ///< closed all round
  bool rest = false;   ///< the workingstep's surroundings are cleared by other steps
  /// False if a rival's passes are known to leave reachable material.
  bool leaves_nothing = true;
  bool hole = false;  ///< a round hole or a profile: made without any strategy
  /// Its passes are those of the strategy without what cuts nothing, or of a form of the strategy that has less of it.
  bool is_shortened = false;
};

/// A workingstep with its candidates, its tool and the feed needed for bounds.
struct SelectionStep {
  std::string feature;
  int workingstep = 0;
  double tool_radius = 0;
  MmPerMin feed;
  StrategyCandidates candidates;
};

/// By what plans are chosen.
enum class ChoiceBy : unsigned char {
  kTime,    ///< known once a step is planned: plans that cannot be faster need not be made
  kFigures  ///< of certificates: every candidate is planned, and the caller ranks them, see rank()
};

using StepPlanner = std::function<StepPlan(int workingstep, const StrategyCandidate& candidate)>;

/// The plans of all workingsteps. The choice depends only on the plans, not on clocks or threads.
class Selection {
 public:
  /// Plans the first two candidates of every step, then the other candidates that may be faster by their least length
  /// and are worth the effort; all in parallel on `threads`. Candidates failing for lack of memory in parallel are
  /// planned once more by themselves. Throws the planner's exception for a step's first strategy, and std::bad_alloc
  /// if no strategy of a step has enough memory.
  Selection(std::vector<SelectionStep> steps, StepPlanner planner, int threads,
            ChoiceBy choice = ChoiceBy::kTime);

  std::size_t steps() const { return steps_.size(); }
  /// Number of plans to choose from for a step.
  std::size_t plans(std::size_t step) const { return ranked_[step].planned; }
  /// Takes plan `k` of every step, or its last.
  void take(std::size_t k);
  /// Ranks the plans of a step by their costs, the least first, and takes the first. Infinite: unknown, or not clean.
  void rank(std::size_t step, const std::vector<double>& costs);
  const Section& section(std::size_t step) const;
  /// Whether the plan taken of any step is_shortened.
  bool has_shortened() const;
  /// Takes the next best plan after one not certified clean: a slower one (including the strategy's own plan after a
  /// rival's), else a fallback. False if no plan is left; the last plan is then kept.
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
    std::optional<double> cost{};         ///< by figures
    std::exception_ptr without_memory{};  ///< exception thrown for lack of memory
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
  ChoiceBy choice_;
  std::vector<RankedCandidates> ranked_;
};

/// Keeps the rapids of all sections, in their order, above the material really left by earlier sections and by
/// plan.earlier. See link/sections/high_rapids.h.
void keep_rapids_high(Toolpath& toolpath, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
