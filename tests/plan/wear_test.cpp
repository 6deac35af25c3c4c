// Passes along walls that the control compensates for wear, that are run again, and that come to size in steps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random.h"
#include "pipeline/check.h"
#include "pipeline/program_feeds.h"
#include "pipeline/run.h"
#include "pipeline/test_drawings.h"
#include "resolve/values/names.h"
#include "support/plans.h"
#include "support/random/random_parts.h"

namespace clearcut {
namespace {

using pipeline::drawn;
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

PlanOptions finishing(const std::string& post) {
  PlanOptions options = test_support::plan_options_with({"endmill:6"});
  options.shop.finish = "walls";
  options.post.dialect = post;
  return options;
}

TEST(SpringPasses, RunTheLastPassAgainAndLeaveTheVerdictAsItIs) {
  PlanOptions options = finishing("linuxcnc");
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
  PlanOptions options = finishing("linuxcnc");
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
    PlanOptions options = finishing(post);
    const auto plain = pipeline::plan_part(pocket(40, 30), [&] {
      PlanOptions lines = options;
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
    const auto along_walls = [](const PlanResult& plan) {
      std::vector<Edge> paths;
      for (const Move& move : plan.toolpath.sections.back().moves)
        if (move.kind == MoveKind::kCut) paths.push_back(move.path);
      return paths;
    };
    EXPECT_EQ(along_walls(result), along_walls(plain)) << "with a new tool nothing is shifted";
    ASSERT_TRUE(result.findings.wear.has_value());
    EXPECT_EQ(result.findings.wear->range_mm, 0.1);
    EXPECT_EQ(result.findings.wear->tools, std::vector<int>{1});
  }
}

std::vector<BulgeVertex> star(Random& random, double inner, double outer) {
  std::vector<BulgeVertex> corners;
  const int count = 3 + static_cast<int>(random.below(7));
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * (i + 0.5 * random.between(0, 1)) / count;
    const double bulge = random.below(3) == 0 ? random.between(-0.1, 0.2) : 0;
    corners.push_back({direction_of(angle) * random.between(inner, outer), bulge});
  }
  return corners;
}

/// A cutter that is smaller or larger, and a D word that says so: the walls come out as drawn, and nothing stays between passes.
TEST(WearCompensation, PlansOfRandomOutlinesHoldOverTheWholeRange) {
  const int count = test_support::random_count(18);
  for (int seed = 0; seed < count; ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 77);
    constexpr const char* kLayers[] = {"POCKET_D3", "PROFILE_D3", "INSIDE_D2", "POCKET_D1"};
    const char* layer = kLayers[seed % 4];
    const auto outline = star(random, 14, 26);
    PlanOptions options = test_support::plan_options_with({random.below(2) == 0 ? "endmill:6" : "endmill:3"});
    options.shop.finish = "walls";
    options.shop.compensation = "wear";
    options.shop.wear_range = random.below(2) == 0 ? 0.05 : 0.1;
    options.accept = {"out-of-reach", "blending"};
    const auto result = pipeline::plan_part(drawn(pipeline::outline(layer, outline)), options);
    EXPECT_EQ(verdict_of(result.findings), Verdict::kClean)
        << layer << ", seed " << seed << ": " << verdict_and_reasons(result.findings);
    EXPECT_THAT(result.program, ::testing::AnyOf(HasSubstr("G41"), HasSubstr("G42")))
        << layer << ", seed " << seed;
  }
}

/// Passes that the control does not shift leave nothing between them when the cutter is smaller, by places of the floor and their
/// distance from the paths alone.
TEST(WearCompensation, ASmallerCutterLeavesNothingBetweenPassesThatAreNotShifted) {
  PlanOptions options = finishing("linuxcnc");
  options.shop.compensation = "wear";
  options.shop.wear_range = 0.2;
  const auto result = pipeline::plan_part(pocket(60, 45), options);
  test_support::expect_clean(result, "with wear");
  double farthest = 0;
  for (double x = 4; x <= 56; x += 0.25) {
    for (double y = 4; y <= 41; y += 0.25) {
      double nearest = 1e9;
      for (const Section& section : result.toolpath.sections)
        for (const Move& move : section.moves)
          if (!is_rapid(move.kind) && move.z_to < -2.99 && move.z_from < -2.99)
            nearest = std::min(nearest, distance(move.path, Vec2{x, y}));
      farthest = std::max(farthest, nearest);
    }
  }
  EXPECT_LE(farthest, 3 - 0.2 + 1e-6);
}

/// The last pass along a profile begins and ends in the slot that was cut, and not on the wall that stays.
TEST(FinishedProfiles, AreLedIntoFromTheirSlot) {
  const std::vector<BulgeVertex> square{{{0, 0}, 0}, {{40, 0}, 0}, {{40, 30}, 0}, {{0, 30}, 0}};
  const struct {
    const char* layer;
    double side;
  } cases[] = {{"PROFILE_D4", 1}, {"INSIDE_D4", -1}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.layer);
    const auto result = pipeline::plan_part(drawn(pipeline::outline(c.layer, square)), finishing("linuxcnc"));
    test_support::expect_clean(result, c.layer);
    const Section& walls = result.toolpath.sections.back();
    const Box box{{0, 0}, {40, 30}};
    for (const Move& move : walls.moves) {
      if (is_rapid(move.kind) || !move.is_vertical()) {
        EXPECT_TRUE(is_rapid(move.kind) || move.z_from == move.z_to) << "nothing sinks along the wall";
        continue;
      }
      const Vec2 p = move.path.from;
      const double inside = std::min({p.x - box.min.x, box.max.x - p.x, p.y - box.min.y, box.max.y - p.y});
      EXPECT_NEAR(-c.side * inside, 3.3, 0.002) << "down where the slot was cut";
    }
  }
}

/// What is asked of a program with the options of its plan is what the plan was found to be.
TEST(FinishDepths, AreNoLimitOfRoughing) {
  PlanOptions options = finishing("linuxcnc");
  options.shop.finish_depths = 2;
  const auto result = pipeline::plan_part(pocket(40, 30), options);
  test_support::expect_clean(result, "in two depths");
  const auto checked = pipeline::check_program(pocket(40, 30), result.program, "a.ngc", options);
  EXPECT_TRUE(checked.findings.faults.empty()) << verdict_and_reasons(checked.findings);
}

TEST(WearCompensation, IsRefusedByNameWhereTheControlHasNone) {
  for (const char* post : {"grbl", "marlin", "heidenhain"}) {
    PlanOptions options = finishing(post);
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
  PlanOptions options = finishing("linuxcnc");
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
  PlanOptions options = finishing("linuxcnc");
  options.shop.compensation = "wear";
  const auto result = pipeline::plan_part(pocket(40, 30), options);
  PlanOptions asked = test_support::plan_options_with({"endmill:6"});
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
  PlanOptions options = test_support::plan_options_with({"endmill:6", "endmill:4"});
  const auto result = pipeline::check_program_alone(Stock{{{-50, -50}, {100, 100}}, -5, 0}, program, "two.nc",
                                                    options, Dialect::kLinuxCnc);
  double along = 0;
  for (const Move& move : result.toolpath.sections.back().moves)
    if (move.path.from.y < 0 && move.path.to.y > 40) along = move.path.to.x;
  EXPECT_NEAR(along, -2, 1e-6) << "the radius of the second tool beside the line";
}

/// Adaptive passes and walls with a lead of 1 mm, compensated for up to 0.1 mm of wear.
PlanOptions worn_by_load(FeedBy by) {
  PlanOptions options = finishing("fanuc");
  options.strategy = "contour";
  options.shop.feed_by = by;
  options.shop.compensation = "wear";
  options.shop.wear_range = 0.1;
  return options;
}

TEST(WearCompensation, FeedsThatFollowTheLoadHoldAtBothEndsOfItsRange) {
  for (const FeedBy by : {FeedBy::kChip, FeedBy::kRemoval}) {
    const auto nominal = [&] {
      PlanOptions options = worn_by_load(by);
      options.shop.compensation.reset();
      options.shop.wear_range.reset();
      return pipeline::plan_part(pocket(40, 30), options);
    }();
    const auto result = pipeline::plan_part(pocket(40, 30), worn_by_load(by));
    test_support::expect_clean(result, resolve::name_of(by));
    EXPECT_LE(result.findings.all.time_s, 1.1 * nominal.findings.all.time_s);
  }
}

TEST(WearCompensation, FeedsOfAProgramAreLoweredForBothEndsOfItsRange) {
  PlanOptions options = worn_by_load(FeedBy::kChip);
  options.shop.feed_by.reset();
  const auto plain = pipeline::plan_part(pocket(40, 30), options);
  options.shop.feed_by = FeedBy::kChip;
  const Part part = pocket(40, 30);
  ProgramQuestion question;
  question.part = &part;
  const auto feeds = pipeline::feeds_of_program(question, plain.program, "p.nc", options);
  EXPECT_TRUE(feeds.after.findings.faults.empty()) << pipeline::faults_of(feeds.after.findings);
  EXPECT_LT(feeds.after.findings.all.time_s, feeds.before.findings.all.time_s);
}

}  // namespace
}  // namespace clearcut
