// Strategies planned for a feature, and their results. Data for tables and certificates.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace clearcut::inline model {

enum class Outcome {
  kKept,           ///< the fastest candidate certified clean
  kWorse,          ///< certified; another one is better by the objective
  kOutrun,         ///< planned, not certified: a faster one is clean
  kNotClean,       ///< certified with faults
  kCannotWin,      ///< not planned: even its least length makes it slower than another candidate
  kTooMuchWork,    ///< left out: planning took more steps than a strategy may use
  kTooMuchMemory,  ///< left out: planning even without other candidates took more memory than available
  kNotTried        ///< not planned: not made for this kind of feature, unlikely to win, or without passes
};

struct CandidateResult {
  std::string strategy;
  std::string stepover;  ///< "" if the strategy decides
  Outcome outcome = Outcome::kNotTried;
  double time_s = 0;       ///< kinematic, of the whole section; 0 if not planned
  double feed_mm = 0;      ///< 0 if not planned
  double least_s = 0;      ///< lower bound on the time of any plan; 0 if unknown
  std::string order = {};  ///< objective of the strategy's own search, if there are several; "" otherwise
  /// Value of the objective, if plans are compared by figures of their certificates; only for plans certified clean.
  std::optional<double> cost = {};
};

/// All candidates for one workingstep, the fastest plan first.
struct StrategySelection {
  std::string feature;
  int workingstep = -1;
  std::vector<CandidateResult> candidates;
  bool made_alike = false;  ///< by any strategy: along the outline, or on one helix

  /// Name of the kept strategy; "" if there is none.
  std::string kept() const;
  /// Number of candidates with a plan.
  std::size_t planned() const;
};

const char* name_of(Outcome outcome);

}  // namespace clearcut::inline model
