// All properties of a strategy: a row of the table in pipeline/selection/strategies.cpp. See
// docs/adding-a-strategy.md.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/layer.h"
#include "model/options/resolved_plan.h"

namespace clearcut::inline model {

/// Conditions for which a strategy is made.
struct StrategyRequest {
  const ResolvedStep& step;
  const ResolvedPlan& plan;
  Stepover stepover;       ///< may differ from the step's stepover in a second attempt with another one
  bool briefly = false;    ///< a short search will do: other strategies are planned as well
  double limit_share = 1;  ///< share of a stated limit of engagement at which cuts aim
  std::optional<ObjectiveKind> order = {};  ///< instead of the plan's objective

  /// The objective of a search for an order of moves.
  Objective objective() const { return order ? Objective{{{*order, 1}}, false} : plan.objective; }
};

/// Sizes of a workingstep, known once a first plan is made.
struct ClearedSize {
  double reached_mm2 = 0;   ///< lower bound of the area that the cutter can clear, summed over the layers
  double legal_rim_mm = 0;  ///< length of the boundary of the centre's legal area, summed likewise
  std::size_t edges = 0;    ///< number of edges of the largest layer's boundary
};

/// Role of a strategy among the candidates of which "auto" keeps the fastest.
enum class AutoUse {
  kNever,
  kFirst,   ///< planned first, the others are compared with it; if it refuses, the user gets its message
  kTried,   ///< planned if it may be faster
  kBriefly  ///< likewise, with a short search
};

struct StrategyEntry {
  std::string name;         ///< name in options and files
  std::string description;  ///< one line for people
  /// Throws InputError for a stepover that the strategy does not know.
  std::function<Strategy(const StrategyRequest&)> make;

  AutoUse in_auto = AutoUse::kNever;
  bool limits_engagement = false;  ///< only such strategies are tried if a limit is requested
  /// False: its lines run in both directions; "auto" does not try it if a direction is requested.
  bool keeps_direction = true;
  bool takes_stepover = true;  ///< false: "auto" does not pass a stepover to it
  /// Stretches of passes that cut nothing are taken out where sides are open. Not of published methods, which are compared as they are,
  /// and not where the engagement is limited: what one pass leaves the next would cut.
  bool loses_air_cuts = false;
  /// In "auto" also planned if a feature has open sides and the first two strategies are planned.
  bool tried_when_open = false;

  /// lower bound on the strategy's length of travel, mm; empty: the area over the cutter's diameter.
  std::function<double(const ClearedSize& size, double radius)> least_length;
  /// Ratio of the strategy's usual time to its least time: if least time times this ratio is not below the best known
  /// time, the strategy is not tried.
  double margin = 1;
  /// Whether a workingstep is small enough to try the strategy; empty: always.
  std::function<bool(const ClearedSize& size, double radius)> is_small_enough;

  /// Objectives of its own search, each a plan to choose from where figures of certificates decide; empty: no search.
  std::vector<ObjectiveKind> orders;
  /// Another form of the strategy, planned as well where sides are open; the fastest is kept. Null: none.
  std::shared_ptr<const StrategyEntry> form_for_open;
  std::vector<std::string> rivals;  ///< names of strategies also planned; the fastest is kept
  /// Stepovers, "" for the strategy's own, tried in turn if no plan is certified clean.
  std::vector<std::string> fallbacks;
};

/// The strategies there are, in the order of their listing.
class StrategyTable {
 public:
  explicit StrategyTable(std::vector<StrategyEntry> entries) : entries_(std::move(entries)) {}

  const std::vector<StrategyEntry>& entries() const { return entries_; }
  /// Null if there is none of this name.
  const StrategyEntry* find(const std::string& name) const {
    for (const StrategyEntry& entry : entries_)
      if (entry.name == name) return &entry;
    return nullptr;
  }

 private:
  std::vector<StrategyEntry> entries_;
};

}  // namespace clearcut::inline model
