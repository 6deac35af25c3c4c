#include "studies/genetic/study_claims.h"

#include <gtest/gtest.h>

#include <map>

namespace clearcut::studies {
namespace {

using Kind = StudyClaim::Kind;

const std::map<std::string, LevelMean> kLevels{
    {"a", {10, 1, 20}}, {"b", {12, 1, 20}}, {"c", {10.5, 1, 20}}, {"none", {}}};

StudyMeans means() {
  StudyMeans of;
  of.mean = [](const std::string& level) { return kLevels.at(level); };
  of.greatest_deviation = [](const std::string&) { return 0.5; };
  of.abscissa = [](const std::string& level) { return level == "a" ? 0.0 : level == "c" ? 1.0 : 2.0; };
  return of;
}

TEST(StudyClaims, ADifferenceBeyondItsErrorDecides) {
  EXPECT_EQ(result_of({Kind::kAbove, "b", "a"}, means()), ClaimResult::kShown);
  EXPECT_EQ(result_of({Kind::kAbove, "a", "b"}, means()), ClaimResult::kContradicted);
  EXPECT_EQ(result_of({Kind::kAbove, "c", "a"}, means()), ClaimResult::kUndecided);
  EXPECT_EQ(result_of({Kind::kAlike, "c", "a"}, means()), ClaimResult::kShown);
  EXPECT_EQ(result_of({Kind::kAlike, "b", "a"}, means()), ClaimResult::kContradicted);
  EXPECT_EQ(result_of({Kind::kNotBelow, "a", "c"}, means()), ClaimResult::kShown);
  EXPECT_EQ(result_of({Kind::kNotBelow, "a", "b"}, means()), ClaimResult::kContradicted);
}

TEST(StudyClaims, PrintedValuesSpreadsAndLines) {
  EXPECT_EQ(result_of({Kind::kIs, "a", "", "", 10.9}, means()), ClaimResult::kShown);
  EXPECT_EQ(result_of({Kind::kIs, "a", "", "", 11.1}, means()), ClaimResult::kContradicted);
  EXPECT_EQ(result_of({Kind::kWithin, "a", "", "", 0.58}, means()), ClaimResult::kShown);
  EXPECT_EQ(result_of({Kind::kWithin, "a", "", "", 0.4}, means()), ClaimResult::kContradicted);
  // 10, 10.5 and 12 at 0, 1 and 2: the line ends at 11 with an error of the root of 6.
  EXPECT_EQ(result_of({Kind::kFasterThanAnyLine, "a", "c", "b"}, means()), ClaimResult::kContradicted);
}

TEST(StudyClaims, WithoutRunsNothingIsSaid) {
  EXPECT_EQ(result_of({Kind::kAbove, "b", "none"}, means()), ClaimResult::kUndecided);
  EXPECT_NE(claim_text({Kind::kAbove, "b", "none"}, means()).find("too few runs"), std::string::npos);
  EXPECT_EQ(claim_text({Kind::kAbove, "b", "a"}, means()),
            "the text: b above a; here: shown (by 2.000 +- 1.414, 99 %)");
}

}  // namespace
}  // namespace clearcut::studies
