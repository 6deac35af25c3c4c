// Tabs along lines that the cutter's centre follows: their places and heights by a second method, what wrong programs are called,
// and where none are left.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/random.h"
#include "pipeline/test_drawings.h"
#include "pipeline/test_tab_heights.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

PlanOptions tabbed(const std::string& tool, int count, TabShape shape = TabShape::kSquare) {
  PlanOptions options = with({tool});
  options.strategy = "contour";
  options.tabs.count = count;
  options.tabs.shape = shape;
  return options;
}

const std::vector<Tab>& tabs_of(const PlanResult& result) {
  return result.part.features.back().profile->tabs;
}

/// Warnings and notes about the part.
std::string told(const PlanResult& result) {
  std::string text;
  for (const Diagnostic& one : result.part.diagnostics.items()) text += one.where + ": " + one.what + "\n";
  return text;
}

std::string open_line(const std::string& layer, const std::vector<BulgeVertex>& vertices) {
  std::string text = outline(layer, vertices);
  text.replace(text.find("\n70\n1\n"), 6, "\n70\n0\n");
  return text;
}

const std::string kStock = box("STOCK_D4", -50, -50, 50, 50);

/// The second method's own words on what stands along one outline.
void expect_hills(const std::vector<Hill>& hills, const PlanOptions& options, double round, int i) {
  const bool square = options.tabs.shape == TabShape::kSquare;
  const double steepness = square ? 0 : *options.tabs.height * 2 / options.tabs.width;
  if (options.tabs.count > 0) {
    EXPECT_EQ(static_cast<int>(hills.size()), options.tabs.count) << i;
  }
  for (std::size_t k = 0; k < hills.size(); ++k) {
    // Places lie 0.05 mm apart; those that stand less than 0.012 mm high are not seen.
    EXPECT_NEAR(hills[k].foot, options.tabs.width, square ? 0.11 : 0.2 + 0.03 / steepness) << i;
    EXPECT_NEAR(hills[k].top, *options.tabs.height, 0.03 * steepness + 0.002) << i;
    EXPECT_LT(hills[k].error, square ? 0.002 : 0.08 * steepness + 0.015) << i;
    const double gap =
        k > 0 ? hills[k].middle - hills[k - 1].middle : hills[k].middle + round - hills.back().middle;
    EXPECT_LT(gap, options.tabs.spacing.value_or(round) + 0.1) << i;
  }
}

PlanOptions random_wish(int i, Random& random) {
  auto options = tabbed("endmill:" + std::to_string(2 + i % 5), i % 2 == 0 ? 2 + i % 3 : 0,
                        i % 4 < 2 ? TabShape::kSquare : TabShape::kTriangular);
  const double spacing = random.between(40, 90);
  if (i % 2 == 1) options.tabs.spacing = spacing;
  options.tabs.width = random.between(2, 6);
  options.tabs.height = random.between(0.5, 2.5);
  if (i % 3 == 0) options.stepdown = 1.1;
  if (i % 5 == 0) options.shop.finish = "walls";
  return options;
}

/// Right: along the line itself, in heights that come from the text of the program alone, there are as many tabs as were asked for, of
/// their width, height and shape, and no farther apart than was asked for; nothing else stands. Cannot see: what stands beside
/// the line.
TEST(FollowedLineTabs, StandAsAskedForInHeightsOfTheirOwn) {
  Random random(23);
  int seen = 0;
  for (int i = 0; i < 120; ++i) {
    const std::vector<Vec2> points = random_outline(random);
    const auto options = random_wish(i, random);
    const double radius = options.tools.front().radius();
    try {
      const auto result = plan_part(drawn(kStock + outline_of("ON_D4", points)), options);
      EXPECT_EQ(faults_of(result.findings), "") << i;
      EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << i;
      const bool square = options.tabs.shape == TabShape::kSquare;
      const double steepness = square ? 0 : *options.tabs.height * 2 / options.tabs.width;
      expect_hills(hills_around(points, {0, radius, -4, steepness}, result.program), options,
                   starts_of(points).back(), i);
      ++seen;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("tabs of")) << i;
    }
  }
  EXPECT_GT(seen, 80);
}

TEST(FollowedLineTabs, OnOpenLinesAndArcsAreClean) {
  const std::string lines[] = {
      open_line("ON_D4", {{{-40, -30}}, {{20, -30}}, {{20, 10}, 0.5}, {{-30, 10}}}),
      circle("ON_D4", {3, 4}, 30), rounded_box("ON_D4", -40, -30, 40, 30, 12),
      open_line("ON_D4", {{{-40, 0}}, {{40, 0}}}),
      outline("ON_D4", {{{-40, -30}}, {{-40, 30}, 0.3}, {{40, 30}, -0.2}, {{40, -30}}})};
  for (const std::string& line : lines) {
    for (const TabShape shape : {TabShape::kSquare, TabShape::kTriangular}) {
      for (const EntryKind entry : {EntryKind::kRamp, EntryKind::kHelix, EntryKind::kPlunge}) {
        auto options = tabbed("endmill:4", 3, shape);
        options.entry = entry;
        options.stepdown = 1.3;
        options.tabs.height = 1.7;
        const auto result = plan_part(drawn(kStock + line), options);
        EXPECT_EQ(faults_of(result.findings), "");
        EXPECT_EQ(verdict_of(result.findings), Verdict::kClean);
        EXPECT_EQ(tabs_of(result).size(), 3u);
      }
    }
  }
}

TEST(FollowedLineTabs, WrongProgramsAreFaultyByName) {
  const Part part = drawn(kStock + box("ON_D4", -40, -25, 40, 25));
  for (const TabShape shape : {TabShape::kSquare, TabShape::kTriangular}) {
    const auto asked = tabbed("endmill:4", 4, shape);
    const auto faults_with = [&](const std::function<void(TabOptions&)>& change) {
      auto other = asked;
      change(other.tabs);
      const auto wrong = plan_part(part, other);
      return faults_of(check_program(part, wrong.program, "wrong.ngc", asked).findings);
    };
    EXPECT_EQ(faults_with([](TabOptions&) {}), "");
    EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.count = 0; }), HasSubstr("missing tab: "));
    EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.count = 3; }), HasSubstr("missing tab: "));
    EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.count = 5; }), HasSubstr("uncut: "));
    EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.height = 1.9; }),
                HasSubstr("stands 1.9 mm high where 2 mm"));
    EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.height = 2.1; }),
                HasSubstr("stands 2.1 mm high where 2 mm"));
    // As high in the middle, and narrower.
    EXPECT_NE(faults_with([](TabOptions& tabs) { tabs.width = 3.9; }), "");
    EXPECT_NE(faults_with([](TabOptions& tabs) { tabs.width = 4.1; }), "");
  }
}

TEST(FollowedLineTabs, TriangularOnesAreRisenOverWithoutAStop) {
  const auto result =
      plan_part(drawn(kStock + circle("ON_D4", {0, 0}, 30)), tabbed("endmill:4", 4, TabShape::kTriangular));
  const Section& section = result.toolpath.sections.back();
  int risen = 0;
  for (const Move& move : section.moves) {
    if (move.kind == MoveKind::kCut && move.z_to > move.z_from) ++risen;
    EXPECT_FALSE(is_rapid(move.kind) && !move.is_vertical() && move.z_to < 0);
  }
  EXPECT_GE(risen, 4);
}

/// Their coordinates have three decimals, or four of an inch: that alone may not make a short move down a side too steep for its feed.
TEST(TriangularTabs, AreGoneDownAtThePlungeFeedWhereCoordinatesAreCoarse) {
  for (const std::string dialect : {"fanuc", "heidenhain"}) {
    for (const bool inch : {false, true}) {
      for (int i = 0; i < 12; ++i) {
        auto options = tabbed("endmill:3", 3, TabShape::kTriangular);
        options.post.dialect = dialect;
        options.post.inch = inch;
        const std::string layer = i % 3 == 0 ? "ON_D4" : i % 3 == 1 ? "PROFILE_D4" : "INSIDE_D4";
        const auto result =
            plan_part(drawn(kStock + circle(layer, {0.37 * i, 0.11 * i}, 21 + 0.73 * i)), options);
        EXPECT_EQ(faults_of(result.findings), "") << dialect << i;
      }
    }
  }
}

TEST(FollowedLineTabs, AreThoseAskedForByTheirPlace) {
  const Part part = drawn(kStock + box("ON_D4", -40, -25, 40, 25));
  for (const TabShape shape : {TabShape::kSquare, TabShape::kTriangular}) {
    auto options = tabbed("endmill:4", 0, shape);
    options.tabs.at = {{-10, -26}, {38, 3}, {1, 28}};
    const auto result = plan_part(part, options);
    EXPECT_EQ(faults_of(result.findings), "");
    ASSERT_EQ(tabs_of(result).size(), 3u);
    const Vec2 centers[] = {{-10, -25}, {40, 3}, {1, 25}};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(distance(tabs_of(result)[i].center, centers[i]), 1e-6);
    options.tabs.at = {{-39, -25}};
    EXPECT_THROW(plan_part(part, options), InputError);
  }
}

/// Where another line crosses a tab would be cut.
TEST(FollowedLineTabs, KeepClearOfLinesThatCross) {
  const std::string across =
      open_line("ON_D4", {{{-40, 0}}, {{40, 0}}}) + open_line("ON_D4", {{{0, -40}}, {{0, 40}}});
  const auto result = plan_part(drawn(kStock + across), tabbed("endmill:3", 3));
  EXPECT_EQ(faults_of(result.findings), "");
  int count = 0;
  for (const Feature& feature : result.part.features)
    if (feature.profile) count += static_cast<int>(feature.profile->tabs.size());
  EXPECT_EQ(count, 6);
}

/// A profile's kerf, too; and what stays for finishing where kerfs cross is no part of either.
TEST(FollowedLineTabs, KeepClearOfProfilesThatCross) {
  const std::string frame = box("PROFILE_D4", -40, -40, 40, 40);
  const std::string lines[] = {
      open_line("ON_D4", {{{-40, -48}}, {{-40, 48}}}), open_line("ON_D4", {{{-48, 3}}, {{48, 3}}}),
      outline("ON_D4", {{{-46, -20}}, {{20, -20}, 0.3}, {{30, 46}, -0.1}, {{-20, 20}}})};
  for (const std::string& line : lines) {
    for (const TabShape shape : {TabShape::kSquare, TabShape::kTriangular}) {
      for (const bool finished : {false, true}) {
        auto options = tabbed("endmill:3", 2, shape);
        options.tabs.width = 2;
        if (finished) options.shop.finish = "walls";
        try {
          EXPECT_EQ(faults_of(plan_part(drawn(kStock + frame + line), options).findings), "") << line;
        } catch (const InputError& error) {
          EXPECT_THAT(error.what(), HasSubstr("tabs of 2 mm fit"));
        }
      }
    }
  }
}

/// What ends within the material frees nothing: it is engraved all along, and said.
TEST(FollowedLineTabs, AreLeftWhereTheLineGoesThroughAlone) {
  const std::string frame = box("PROFILE_D4", -40, -40, 40, 40),
                    engraved = circle("ENGRAVE_D0.5", {0, 0}, 20);
  const auto shallow = plan_part(drawn(kStock + frame + engraved), tabbed("endmill:3", 3));
  EXPECT_EQ(faults_of(shallow.findings), "");
  EXPECT_THAT(told(shallow), HasSubstr("ENGRAVE_D0.5: the depth ends within the material"));
  EXPECT_EQ(shallow.part.features.size(), 3u);
  // Without a stock the deepest cut tells where the material ends.
  const auto stockless = plan_part(drawn(frame + engraved), tabbed("endmill:3", 3));
  EXPECT_EQ(stockless.part.features.size(), 3u);
  EXPECT_EQ(plan_part(drawn(engraved + box("ON_D4", -40, -40, 40, 40)), tabbed("endmill:3", 3))
                .part.features.size(),
            3u);
  const auto none = plan_part(drawn(kStock + frame), tabbed("endmill:3", 3));
  EXPECT_THAT(told(none), Not(HasSubstr("within the material")));
}

/// A part that would come loose is refused; waste within it is warned of.
TEST(FollowedLineTabs, ThatDoNotFitAreSaid) {
  const std::string narrow = circle("ON_D4", {0, 0}, 5);
  EXPECT_THROW(plan_part(drawn(kStock + narrow), tabbed("endmill:3", 3)), InputError);
  const std::string within = box("PROFILE_D4", -40, -40, 40, 40) + narrow;
  EXPECT_THAT(told(plan_part(drawn(kStock + within), tabbed("endmill:3", 3))),
              HasSubstr("ON_D4: only 0 of 3 tabs of 4 mm fit"));
  const auto both =
      plan_part(drawn(kStock + box("ON_D4", -40, -40, 40, 40) + narrow), tabbed("endmill:3", 3));
  EXPECT_THAT(told(both), HasSubstr("only 0 of 3 tabs of 4 mm fit"));
  EXPECT_EQ(tabs_of(both).size(), 3u);
}

TEST(FollowedLineTabs, PointedAndRoundTipsLeaveNone) {
  for (const char* tool : {"vbit:90deg:12", "ball:4"}) {
    EXPECT_THROW(plan_part(drawn(kStock + box("ON_D4", -40, -40, 40, 40)), tabbed(tool, 3)), InputError)
        << tool;
    const auto open = plan_part(drawn(kStock + open_line("ON_D4", {{{-30, 0}}, {{30, 0}}})), tabbed(tool, 3));
    EXPECT_THAT(told(open), HasSubstr("tabs are left by end mills")) << tool;
  }
  // Where there is an end mill, too, it cuts what goes through, and the tip what is engraved.
  auto both = tabbed("vbit:90deg:12", 3);
  both.tools.push_back(with({"endmill:3"}).tools.front());
  both.tools.back().number = 2;
  const auto result =
      plan_part(drawn(kStock + box("ON_D4", -40, -40, 40, 40) + circle("ENGRAVE_D0.5", {0, 0}, 20)), both);
  EXPECT_EQ(faults_of(result.findings), "");
  EXPECT_EQ(tabs_of(result).size(), 3u);
  std::vector<int> numbers;
  for (const Workingstep& step : result.part.workplan) numbers.push_back(tool_of(result.part, step).number);
  EXPECT_THAT(numbers, ::testing::UnorderedElementsAre(1, 2, 2));
}

TEST(FollowedLineSkin, IsLeftUnderLinesThatGoThroughAlone) {
  auto options = tabbed("endmill:3", 0);
  const std::string engraved = circle("ENGRAVE_D0.5", {0, 0}, 20);
  const Part part = drawn(kStock + box("ON_D4", -40, -40, 40, 40) + engraved);
  const auto through = plan_part(part, options);
  options.tabs.skin = 0.4;
  const auto result = plan_part(part, options);
  EXPECT_EQ(faults_of(result.findings), "");
  std::vector<double> floors;
  for (const Feature& feature : result.part.features) floors.push_back(feature.floor_z);
  EXPECT_THAT(floors, ::testing::UnorderedElementsAre(::testing::DoubleNear(-3.6, 1e-9),
                                                      ::testing::DoubleNear(-0.5, 1e-9)));
  EXPECT_THAT(told(result), HasSubstr("no skin is left"));
  EXPECT_THAT(faults_of(check_program(part, through.program, "through.ngc", options).findings),
              HasSubstr("gouge: "));
}

}  // namespace
}  // namespace clearcut::pipeline
