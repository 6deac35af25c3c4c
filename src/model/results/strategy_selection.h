// Which strategies were planned for a feature, and what became of them. Data for tables and certificates.
#pragma once

#include <string>
#include <vector>

namespace clearcut::inline model {

enum class Outcome {
  kKept,           ///< the fastest that is certified clean
  kOutrun,         ///< planned, not certified: a faster one is clean
  kNotClean,       ///< certified with faults
  kCannotWin,      ///< not planned: by its least length alone it is slower than another
  kTooMuchWork,    ///< left out: planning it took more steps than a strategy is given
  kTooMuchMemory,  ///< left out: planning it alone took more memory than there was
  kNotTried        ///< not planned: not made for such a feature, hardly to win there, or it has no passes
};

struct CandidateResult {
  std::string strategy;
  std::string stepover;  ///< "" where the strategy decides
  Outcome outcome = Outcome::kNotTried;
  double time_s = 0;   ///< kinematic, of the whole section; 0 where it was not planned
  double feed_mm = 0;  ///< 0 where it was not planned
  double least_s = 0;  ///< no plan of it can be faster; 0 where nothing is known
};

/// All that was considered for one workingstep, the fastest plan first.
struct StrategySelection {
  std::string feature;
  int workingstep = -1;
  std::vector<CandidateResult> candidates;

  /// Name of the strategy that was kept; "" when there is none.
  std::string kept() const;
};

const char* name_of(Outcome outcome);

}  // namespace clearcut::inline model
