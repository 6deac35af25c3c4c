// Plans that allow a machine to leave the path.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "pipeline/test_drawings.h"
#include "pipeline/texts.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

/// A pocket with a bulged side, a corner that reaches inwards, and a hole in its middle that stays.
Part pocket() {
  return drawn(
      outline("POCKET_D3", {{{0, 0}}, {{50, 0}, 0.2}, {{50, 40}}, {{30, 40}}, {{30, 32}}, {{0, 32}}}) +
      box("POCKET_D3", 20, 12, 28, 18));
}

PlanOptions asking(const std::string& strategy, double at_least) {
  PlanOptions options = with({"endmill:6"});
  options.strategy = strategy;
  options.shop.margin_at_least = at_least;
  return options;
}

class MarginOf : public ::testing::TestWithParam<const char*> {};

TEST_P(MarginOf, APlanIsAsWideAsAsked) {
  PlanOptions near = asking(GetParam(), 0.0025);
  near.shop.margin_uncut = 0.02;
  const PlanResult exact = plan_part(pocket(), near);
  ASSERT_TRUE(exact.margin);
  EXPECT_GE(exact.margin->least()->mm, 0.0025);
  EXPECT_EQ(verdict_of(exact.findings), Verdict::kClean);
  PlanOptions wide = asking(GetParam(), 0.02);
  wide.shop.margin_uncut = 0.032;
  wide.shop.margin_gouge = 0.02;
  const PlanResult worn = plan_part(pocket(), wide);
  EXPECT_GE(worn.margin->least()->mm, 0.02);
  EXPECT_EQ(verdict_of(worn.findings), Verdict::kClean);
}

INSTANTIATE_TEST_SUITE_P(Strategies, MarginOf, ::testing::Values("contour", "zigzag", "spiral", "adaptive"));

TEST(MarginPlan, IsInThePicture) {
  PlanOptions options = asking("contour", 0.0025);
  options.shop.margin_uncut = 0.02;
  const PlanResult result = plan_part(pocket(), options);
  const std::string picture = write_picture(result);
  EXPECT_THAT(picture, HasSubstr("Holds for 0.0"));
  EXPECT_THAT(picture, HasSubstr(">holds for 0.0"));
  EXPECT_THAT(write_picture(plan_part(pocket(), with({"endmill:6"}))),
              ::testing::Not(HasSubstr("machine error")));
}

TEST(MarginPlan, IsRefusedWhereTheBoundsCannotHoldIt) {
  std::string said;
  try {
    resolve::check(asking("contour", 0.02));
  } catch (const InputError& error) {
    said = error.what();
  }
  EXPECT_THAT(said, HasSubstr("--margin-at-least: 0.02 mm cannot be held where 0.01 mm may be left and 0.001 "
                              "mm be cut too deep"));
}

TEST(MarginPlan, IsAnOpenConditionWhereAProgramHasLess) {
  PlanOptions plain = with({"endmill:6"});
  plain.strategy = "contour";
  const PlanResult result = plan_part(pocket(), plain);
  EXPECT_FALSE(result.margin);
  const CheckResult checked = check_program(pocket(), result.program, "p.ngc", asking("contour", 0.0025));
  EXPECT_LT(checked.margin->least()->mm, 0.0025);
  EXPECT_EQ(verdict_of(checked.findings), Verdict::kConditional);
  EXPECT_EQ(checked.findings.conditions.back().name, "margin");
  EXPECT_THAT(checked.findings.conditions.back().text, HasSubstr("0.0025 mm were asked for"));
}

}  // namespace
}  // namespace clearcut::pipeline
