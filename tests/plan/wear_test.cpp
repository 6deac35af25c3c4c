// Passes along walls that the control compensates for wear, that are run again, and that come to size in steps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "pipeline/check.h"
#include "pipeline/run.h"
#include "support/plans.h"

namespace clearcut {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Part pocket(double width, double height) {
  Part part;
  part.name = part.source_file = "pocket";
  Feature feature;
  feature.name = "POCKET";
  const Region outline = Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{0, 0}, {width, 0}, {width, height}, {0, height}}), {});
  feature.target = feature.allowed = {outline};
  feature.floor_z = -3;
  part.features.push_back(feature);
  part.workplan.push_back({"STEP", "", 0, {}});
  return part;
}

resolve::PlanOptions finishing(const std::string& post) {
  resolve::PlanOptions options = test_support::plan_options_with({"endmill:6"});
  options.shop.finish = "walls";
  options.post.dialect = post;
  return options;
}

TEST(SpringPasses, RunTheLastPassAgainAndLeaveTheVerdictAsItIs) {
  resolve::PlanOptions options = finishing("linuxcnc");
  options.shop.spring_passes = 2;
  const auto result = pipeline::plan_part(pocket(40, 30), options);
  test_support::expect_clean(result, "with spring passes");
  ASSERT_EQ(result.toolpath.sections.size(), 4u) << "rough, walls, twice again";
  const auto length = [&](std::size_t k) {
    double sum = 0;
    for (const Move& move : result.toolpath.sections[k].moves)
      if (move.kind == MoveKind::kCut) sum += move.length();
    return sum;
  };
  EXPECT_NEAR(length(1), 2 * (34 + 24) + kPi * 1.5, 0.01)
      << "once round, and two quarter circles of its leads";
  EXPECT_NEAR(length(2), length(1), 1e-6);
  EXPECT_NEAR(length(3), length(1), 1e-6);
}

TEST(FinishSteps, BringWallsToSizeInPassesBesideEachOther) {
  resolve::PlanOptions options = finishing("linuxcnc");
  options.shop.finish_stock = 0.4;
  options.shop.finish_steps = 2;
  const auto result = pipeline::plan_part(pocket(40, 30), options);
  test_support::expect_clean(result, "in two steps");
  ASSERT_EQ(result.toolpath.sections.size(), 3u);
  const auto nearest = [&](std::size_t k) {
    double least = 1e9;
    for (const Move& move : result.toolpath.sections[k].moves) least = std::min(least, move.path.to.x);
    return least;
  };
  EXPECT_NEAR(nearest(0), 3.4, 0.002);
  EXPECT_NEAR(nearest(1), 3.2, 0.002);
  EXPECT_NEAR(nearest(2), 3.0, 0.002);
}

TEST(WearCompensation, IsWrittenAlongWallsAndHoldsAtBothEndsOfItsRange) {
  for (const char* post : {"linuxcnc", "haas", "siemens"}) {
    SCOPED_TRACE(post);
    resolve::PlanOptions options = finishing(post);
    const auto plain = pipeline::plan_part(pocket(40, 30), [&] {
      resolve::PlanOptions lines = options;
      lines.lead_angle = Radians::of_degrees(45);
      return lines;
    }());
    options.shop.compensation = "wear";
    const auto result = pipeline::plan_part(pocket(40, 30), options);
    EXPECT_TRUE(result.findings.faults.empty()) << verdict_and_reasons(result.findings);
    EXPECT_EQ(verdict_of(result.findings), verdict_of(plain.findings))
        << verdict_and_reasons(result.findings);
    EXPECT_THAT(result.program, HasSubstr("G41"));
    EXPECT_THAT(result.program, HasSubstr("G40"));
    EXPECT_THAT(plain.program, Not(HasSubstr("G41")));
    EXPECT_EQ(result.findings.all.feed_mm, plain.findings.all.feed_mm)
        << "with a new tool nothing is shifted";
    ASSERT_TRUE(result.findings.wear.has_value());
    EXPECT_EQ(result.findings.wear->range_mm, 0.1);
    EXPECT_EQ(result.findings.wear->tools, std::vector<int>{1});
  }
}

TEST(WearCompensation, IsRefusedByNameWhereTheControlHasNone) {
  for (const char* post : {"grbl", "marlin", "heidenhain"}) {
    resolve::PlanOptions options = finishing(post);
    options.shop.compensation = "wear";
    try {
      pipeline::plan_part(pocket(40, 30), options);
      FAIL() << post;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("--compensation: " + std::string(post) + " has no"));
    }
  }
}

TEST(WearCompensation, LeadsThatAreShorterThanTheRangeAreRefused) {
  resolve::PlanOptions options = finishing("linuxcnc");
  options.shop.compensation = "wear";
  options.shop.wear_range = 0.5;
  options.lead = 0.6;
  try {
    pipeline::plan_part(pocket(40, 30), options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("less than twice the range of wear"));
  }
}

TEST(WearCompensation, VerifyAsksTheSameOfTheProgram) {
  resolve::PlanOptions options = finishing("linuxcnc");
  options.shop.compensation = "wear";
  const auto result = pipeline::plan_part(pocket(40, 30), options);
  resolve::PlanOptions asked = test_support::plan_options_with({"endmill:6"});
  asked.shop.compensation = "wear";
  const auto checked = pipeline::check_program(pocket(40, 30), result.program, "a.ngc", asked);
  EXPECT_EQ(verdict_of(checked.findings), Verdict::kClean) << verdict_and_reasons(checked.findings);
  ASSERT_TRUE(checked.findings.wear.has_value());
  // On the other side a larger D cuts into the wall.
  std::string wrong = result.program;
  for (std::size_t at = wrong.find("G41 D"); at != std::string::npos; at = wrong.find("G41 D"))
    wrong[at + 2] = '2';
  EXPECT_EQ(verdict_of(pipeline::check_program(pocket(40, 30), wrong, "a.ngc", asked).findings),
            Verdict::kFaulty);
  // Taken for the radius of the cutter, D is more than the lines that lead in.
  asked.shop.compensation = "radius";
  EXPECT_THROW(pipeline::check_program(pocket(40, 30), result.program, "a.ngc", asked), InputError);
}

/// Tools that nobody numbers are T1, T2 and so on, as plans number them.
TEST(Compensation, ToolsWithoutNumbersHaveThoseOfTheirOrder) {
  const std::string program =
      "G21 G90 G17 G94 G40 G49 G54\nT2 M6\nS5000 M3\nG0 X-20 Y-20 Z5\nG1 Z-2 F200\nG41 D2 X0 Y-10 F600\nY50\n"
      "G40 X-30 Y60\nG0 Z5\nM30\n";
  resolve::PlanOptions options = test_support::plan_options_with({"endmill:6", "endmill:4"});
  const auto result = pipeline::check_program_alone(Stock{{{-50, -50}, {100, 100}}, -5, 0}, program, "two.nc",
                                                    options, read::gcode::Dialect::kLinuxCnc);
  double along = 0;
  for (const Move& move : result.toolpath.sections.back().moves)
    if (move.path.from.y < 0 && move.path.to.y > 40) along = move.path.to.x;
  EXPECT_NEAR(along, -2, 1e-6) << "the radius of the second tool beside the line";
}

}  // namespace
}  // namespace clearcut
