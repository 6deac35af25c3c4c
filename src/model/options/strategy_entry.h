// What the software knows of a strategy: a row of the table in pipeline/selection/strategies.cpp. See docs/adding-a-strategy.md.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/layer.h"
#include "model/options/resolved_plan.h"

namespace clearcut::inline model {

/// What a strategy is made for.
struct StrategyRequest {
  const ResolvedStep& step;
  const ResolvedPlan& plan;
  Stepover stepover;     ///< may differ from that of the step where it is tried again with another
  bool briefly = false;  ///< a short search will do: other strategies are planned as well
};

/// What is known of a workingstep once a first plan is made.
struct ClearedSize {
  double reached_mm2 = 0;   ///< area of what the cutter can clear, at least, summed over the layers
  double legal_rim_mm = 0;  ///< length of the boundary of where its centre may be, likewise
  std::size_t edges = 0;    ///< of the largest layer's boundary
};

/// Whether a strategy is among those of which "auto" keeps the fastest.
enum class AutoUse {
  kNever,
  kFirst,   ///< planned first, the others are measured against it; its refusal is the user's
  kTried,   ///< planned where it may be faster
  kBriefly  ///< likewise, with a short search
};

struct StrategyEntry {
  std::string name;         ///< as options and files say it
  std::string description;  ///< one line for people
  /// Throws InputError for a stepover that means nothing to it.
  std::function<Strategy(const StrategyRequest&)> make;

  AutoUse in_auto = AutoUse::kNever;
  bool limits_engagement = false;  ///< the only kind that is tried where a limit is asked for
  bool keeps_direction = true;  ///< false: its lines go both ways; in "auto" not tried where one is asked for
  bool takes_stepover = true;   ///< false: in "auto" a stepover is not handed to it
  bool tried_when_open =
      false;  ///< in "auto" where a feature has open sides and the first two are planned, too

  /// mm, less than which it cannot travel; empty: the area over the cutter's diameter.
  std::function<double(const ClearedSize& size, double radius)> least_length;
  /// How far above its least time it stays nearly everywhere: nearer to the best known it is not tried.
  double margin = 1;
  /// Whether a workingstep is small enough to try it; empty: always.
  std::function<bool(const ClearedSize& size, double radius)> is_small_enough;

  std::vector<std::string> rivals;  ///< names of strategies that are planned beside it, the fastest is kept
  std::vector<std::string>
      fallbacks;  ///< stepovers, "" its own, tried in turn where no plan is certified clean
};

/// The strategies there are, in the order of their listing.
class StrategyTable {
 public:
  explicit StrategyTable(std::vector<StrategyEntry> entries) : entries_(std::move(entries)) {}

  const std::vector<StrategyEntry>& entries() const { return entries_; }
  /// Null when there is none of that name.
  const StrategyEntry* find(const std::string& name) const {
    for (const StrategyEntry& entry : entries_)
      if (entry.name == name) return &entry;
    return nullptr;
  }

 private:
  std::vector<StrategyEntry> entries_;
};

}  // namespace clearcut::inline model
