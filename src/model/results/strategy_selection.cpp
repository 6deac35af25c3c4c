#include "model/results/strategy_selection.h"

#include <algorithm>

namespace clearcut::inline model {

std::string StrategySelection::kept() const {
  const auto found = std::find_if(candidates.begin(), candidates.end(),
                                  [](const CandidateResult& one) { return one.outcome == Outcome::kKept; });
  return found == candidates.end() ? "" : found->strategy;
}

std::size_t StrategySelection::planned() const {
  return static_cast<std::size_t>(std::count_if(candidates.begin(), candidates.end(),
                                                [](const CandidateResult& one) { return one.time_s > 0; }));
}

const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::kKept:
      return "kept";
    case Outcome::kWorse:
      return "worse";
    case Outcome::kOutrun:
      return "slower";
    case Outcome::kNotClean:
      return "not clean";
    case Outcome::kCannotWin:
      return "cannot win";
    case Outcome::kTooMuchWork:
      return "too much work";
    case Outcome::kTooMuchMemory:
      return "too much memory";
    case Outcome::kNotTried:
      break;
  }
  return "not tried";
}

}  // namespace clearcut::inline model
