// What the Tour text finds in its studies, held against the runs of ours with the confidence that they allow.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace clearcut::studies {

/// Of one level of a study; the error is that of eq. 4.11.
struct LevelMean {
  double mean = 0;
  double error = 0;
  int runs = 0;
};

/// A sentence of the text about one or two levels.
struct StudyClaim {
  enum class Kind {
    kAbove,              ///< the first level's mean is above the second's
    kNotBelow,           ///< the first level's mean is no worse than the second's
    kAlike,              ///< the two means are the same
    kIs,                 ///< the first level's mean is `value`
    kWithin,             ///< no run of the first level is further than `value` from its mean
    kFasterThanAnyLine,  ///< the third level lies above the line through the first and the second
  };
  Kind kind = Kind::kAbove;
  std::string first, second, third = {};
  double value = 0;
};

/// What the runs say of a claim.
enum class ClaimResult {
  kShown,         ///< the difference is beyond its error
  kContradicted,  ///< so is the opposite
  kUndecided      ///< so many runs cannot tell
};

/// What is known of a study's levels; a name that has no runs yet has none.
struct StudyMeans {
  std::function<LevelMean(const std::string& level)> mean;
  std::function<double(const std::string& level)> greatest_deviation;
  /// Of a level, where the claim is about a curve.
  std::function<double(const std::string& level)> abscissa;
};

ClaimResult result_of(const StudyClaim& claim, const StudyMeans& means);

/// "the text: roulette above rank; here 1.48 +- 0.03 and 1.34 +- 0.04: shown (difference 0.14 +- 0.05, 99 %)".
std::string claim_text(const StudyClaim& claim, const StudyMeans& means);

}  // namespace clearcut::studies
