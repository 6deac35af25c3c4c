#include "model/results/contest.h"

#include <algorithm>

namespace clearcut::inline model {

std::string Contest::kept() const {
  const auto found = std::find_if(contestants.begin(), contestants.end(),
                                  [](const Contestant& one) { return one.outcome == Outcome::kKept; });
  return found == contestants.end() ? "" : found->strategy;
}

const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::kKept:
      return "kept";
    case Outcome::kOutrun:
      return "slower";
    case Outcome::kNotClean:
      return "not clean";
    case Outcome::kCannotWin:
      return "cannot win";
    case Outcome::kTooMuchWork:
      return "too much work";
    case Outcome::kNotTried:
      break;
  }
  return "not tried";
}

}  // namespace clearcut::inline model
