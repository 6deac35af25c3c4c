#include "studies/genetic/study_claims.h"

#include <fmt/format.h>

#include <cmath>

namespace clearcut::studies {
namespace {

using Kind = StudyClaim::Kind;

/// A figure that is above 0 where a claim holds, with its error.
struct Excess {
  double value = 0;
  double error = 0;
};

/// The error of a sum or a difference of two figures.
double of_independent(double error, double other) {
  return std::sqrt(error * error + other * other);
}

Excess difference(const LevelMean& a, const LevelMean& b) {
  return {a.mean - b.mean, of_independent(a.error, b.error)};
}

/// How far the third level lies above the line through the other two.
Excess above_line(const StudyClaim& claim, const StudyMeans& means) {
  const double x1 = means.abscissa(claim.first), x2 = means.abscissa(claim.second),
               x3 = means.abscissa(claim.third);
  const LevelMean y1 = means.mean(claim.first), y2 = means.mean(claim.second), y3 = means.mean(claim.third);
  const double t = (x3 - x1) / (x2 - x1);
  return {y3.mean - (y1.mean + t * (y2.mean - y1.mean)),
          of_independent(y3.error, of_independent((1 - t) * y1.error, t * y2.error))};
}

Excess excess_of(const StudyClaim& claim, const StudyMeans& means) {
  switch (claim.kind) {
    case Kind::kIs:
      return {means.mean(claim.first).mean - claim.value, means.mean(claim.first).error};
    case Kind::kWithin:
      return {claim.value - means.greatest_deviation(claim.first), 0};
    case Kind::kFasterThanAnyLine:
      return above_line(claim, means);
    default:
      return difference(means.mean(claim.first), means.mean(claim.second));
  }
}

bool are_there(const StudyClaim& claim, const StudyMeans& means) {
  constexpr int kFewest = 2;  // runs with a standard deviation
  for (const std::string* level : {&claim.first, &claim.second, &claim.third})
    if (!level->empty() && means.mean(*level).runs < kFewest) return false;
  return true;
}

std::string words_of(const StudyClaim& claim) {
  switch (claim.kind) {
    case Kind::kAbove:
      return fmt::format("{} above {}", claim.first, claim.second);
    case Kind::kNotBelow:
      return fmt::format("{} no worse than {}", claim.first, claim.second);
    case Kind::kAlike:
      return fmt::format("{} and {} alike", claim.first, claim.second);
    case Kind::kIs:
      return fmt::format("{:g} of {}", claim.value, claim.first);
    case Kind::kWithin:
      return fmt::format("no run of {} more than {:g} from the mean", claim.first, claim.value);
    case Kind::kFasterThanAnyLine:
      return fmt::format("exponential: {} above the line through {} and {}", claim.third, claim.first,
                         claim.second);
  }
  return "";
}

const char* words_of(ClaimResult result) {
  switch (result) {
    case ClaimResult::kShown:
      return "shown";
    case ClaimResult::kContradicted:
      return "contradicted";
    case ClaimResult::kUndecided:
      return "not decided by so many runs";
  }
  return "";
}

}  // namespace

ClaimResult result_of(const StudyClaim& claim, const StudyMeans& means) {
  if (!are_there(claim, means)) return ClaimResult::kUndecided;
  const Excess excess = excess_of(claim, means);
  switch (claim.kind) {
    case Kind::kAlike:
    case Kind::kIs:
      return std::abs(excess.value) <= excess.error ? ClaimResult::kShown : ClaimResult::kContradicted;
    case Kind::kNotBelow:
    case Kind::kWithin:
      return excess.value >= -excess.error ? ClaimResult::kShown : ClaimResult::kContradicted;
    case Kind::kFasterThanAnyLine:
      return excess.value > excess.error ? ClaimResult::kShown : ClaimResult::kContradicted;
    case Kind::kAbove:
      break;
  }
  if (excess.value > excess.error) return ClaimResult::kShown;
  return excess.value < -excess.error ? ClaimResult::kContradicted : ClaimResult::kUndecided;
}

std::string claim_text(const StudyClaim& claim, const StudyMeans& means) {
  if (!are_there(claim, means)) return fmt::format("the text: {}; here too few runs to say", words_of(claim));
  const Excess excess = excess_of(claim, means);
  return fmt::format("the text: {}; here: {} (by {:.3f} +- {:.3f}, 99 %)", words_of(claim),
                     words_of(result_of(claim, means)), excess.value, excess.error);
}

}  // namespace clearcut::studies
