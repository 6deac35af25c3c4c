// Tabs through the whole way: their shapes and places, what wrong programs are called, and heights by a second method.
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

PlanOptions triangular(const std::string& tool, int count = 0) {
  PlanOptions options = with({tool});
  options.strategy = "contour";
  options.tabs.count = count;
  options.tabs.shape = TabShape::kTriangular;
  return options;
}

/// The rounded end of a cutter leaves a fin at the foot of the wall, which is said; the far side of its kerf is nobody's wall.
TEST(CutOuts, RoundedCornersOwnNoFarSideOfTheKerf) {
  for (const std::string layer : {"PROFILE_D5", "INSIDE_D5"}) {
    auto options = with({"bullnose:6:corner=1"});
    options.strategy = "contour";
    const PlanResult result =
        plan_part(drawn(box("STOCK_D5", -20, -20, 60, 50) +
                        outline(layer, {{{0, 0}}, {{40, 0}}, {{40, 14}}, {{20, 14}}, {{20, 30}}, {{0, 30}}})),
                  options);
    EXPECT_EQ(faults_of(result.findings), "") << layer;
    EXPECT_TRUE(std::any_of(result.findings.conditions.begin(), result.findings.conditions.end(),
                            [](const Condition& one) { return one.name == "out-of-reach"; }));
  }
}

/// Nowhere in a profile shallower than its radius does a ball come to its width: beside tabs, above them, and in shallow profiles.
TEST(CutOuts, RoundEndsOwnNoFarSideOfTheKerf) {
  const std::string stock = box("STOCK_D6", -20, -20, 60, 50);
  for (const std::string layer : {"PROFILE_D1", "PROFILE_D6", "INSIDE_D6"}) {
    for (const double high : {1.0, 4.0}) {
      for (const double left : {0.0, 0.2}) {
        auto options = with({"ball:6"});
        options.strategy = "contour";
        options.allowance = options.allowance_floor = left;
        options.accept = {"out-of-reach"};
        if (layer != "PROFILE_D1") {
          options.tabs.count = 2;
          options.tabs.height = high;
        }
        const PlanResult result = plan_part(drawn(stock + rounded_box(layer, 0, 0, 40, 30, 5)), options);
        EXPECT_EQ(faults_of(result.findings), "") << layer << ' ' << high << ' ' << left;
      }
    }
  }
}

/// Stock to leave stands on the walls and the floor beside tabs, which are as high as they are asked all the same.
TEST(Tabs, StandBesideStockThatIsLeft) {
  for (const TabShape shape : {TabShape::kSquare, TabShape::kTriangular}) {
    for (const char* finish : {"", "walls", "all"}) {
      PlanOptions options = with({"endmill:5"});
      options.strategy = "contour";
      options.tabs.count = 2;
      options.tabs.shape = shape;
      options.allowance = 0.3;
      options.allowance_floor = 0.1;
      if (*finish) options.shop.finish = finish;
      const auto result =
          plan_part(drawn(box("STOCK_D5", -10, -10, 50, 40) + box("PROFILE_D5", 0, 0, 40, 30)), options);
      EXPECT_EQ(faults_of(result.findings), "") << finish;
    }
  }
}

/// On curved outlines the sides of tabs are straight, so that stock on them is more along the kerf within than around the outline.
TEST(Tabs, StandBesideStockThatIsLeftAlongArcs) {
  for (const std::string layer : {"PROFILE_D2", "INSIDE_D2"}) {
    for (const double diameter : {14.0, 20.0, 40.0}) {
      for (const double left : {0.1, 0.5}) {
        PlanOptions options = with({"endmill:3"});
        options.strategy = "contour";
        options.tabs.count = 2;
        options.allowance = left;
        const auto result = plan_part(drawn(outline(layer, {{{0, 0}, 1}, {{diameter, 0}, 1}})), options);
        EXPECT_EQ(faults_of(result.findings), "") << layer << ' ' << diameter << ' ' << left;
      }
    }
  }
}

/// Right: along the middle of the kerf, in heights that come from the text of the program alone, there are as many triangles as were
/// asked for, of their width and height, and no farther apart than was asked for; nothing else stands. Cannot see: what stands
/// beside the middle, and in the corners.
TEST(TriangularTabs, StandAsAskedForInHeightsOfTheirOwn) {
  Random random(11);
  int seen = 0;
  for (int i = 0; i < 40; ++i) {
    const std::vector<Vec2> points = random_outline(random);
    const int mill = 2 + i % 5;
    auto options = triangular("endmill:" + std::to_string(mill), i % 2 == 0 ? 2 + i % 3 : 0);
    const double spacing = random.between(40, 90);
    if (i % 2 == 1) options.tabs.spacing = spacing;
    options.tabs.width = random.between(2, 6);
    options.tabs.height = random.between(0.5, 2.5);
    if (i % 3 == 0) options.stepdown = 1.1;
    if (i % 5 == 0) options.shop.finish = "walls";
    const double steepness = *options.tabs.height * 2 / options.tabs.width;
    try {
      const auto result = plan_part(drawn(outline_of("PROFILE_D4", points)), options);
      EXPECT_EQ(faults_of(result.findings), "") << i;
      const std::vector<Hill> hills =
          hills_around(points, {mill / 2.0, mill / 2.0, -4, steepness}, result.program);
      if (options.tabs.count > 0)
        EXPECT_EQ(static_cast<int>(hills.size()), options.tabs.count) << i;
      else
        ASSERT_GE(hills.size(), 2u) << i;
      for (std::size_t k = 0; k < hills.size(); ++k) {
        EXPECT_NEAR(hills[k].foot, options.tabs.width, 0.2 + 0.03 / steepness) << i;
        EXPECT_NEAR(hills[k].top, *options.tabs.height, 0.03 * steepness + 0.002) << i;
        EXPECT_LT(hills[k].error, 0.08 * steepness + 0.015) << i;
        const double round = starts_of(points).back();
        const double gap =
            k > 0 ? hills[k].middle - hills[k - 1].middle : hills[k].middle + round - hills.back().middle;
        EXPECT_LT(gap, options.tabs.spacing.value_or(round) + 0.1) << i;
      }
      ++seen;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("tabs of")) << i;
    }
  }
  EXPECT_GT(seen, 25);
}

/// On arcs, inside outlines, and through the material.
TEST(TriangularTabs, AreCleanOnArcsAndThrough) {
  for (const char* layer : {"INSIDE_D5", "PROFILE_D5"}) {
    for (const std::string& entities : {circle(layer, {3, 4}, 30), rounded_box(layer, 0, 0, 70, 50, 20)}) {
      for (const EntryKind entry : {EntryKind::kRamp, EntryKind::kHelix, EntryKind::kPlunge}) {
        auto options = triangular("endmill:4", 5);
        options.entry = entry;
        options.stepdown = 1.3;
        options.tabs.height = 1.7;
        if (entry == EntryKind::kHelix) options.lead = 1;
        const auto result = plan_part(drawn(entities), options);
        EXPECT_EQ(faults_of(result.findings), "") << layer;
        EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << layer;
      }
    }
  }
}

TEST(TriangularTabs, AreRisenOverWithoutAStop) {
  const auto result = plan_part(drawn(box("PROFILE_D6", 0, 0, 80, 50)), triangular("endmill:4", 4));
  EXPECT_EQ(faults_of(result.findings), "");
  // One way down and one way up for all four.
  const Section& section = result.toolpath.sections.back();
  EXPECT_EQ(std::count_if(section.moves.begin(), section.moves.end(),
                          [](const Move& move) { return is_rapid(move.kind) && move.z_to > move.z_from; }),
            1);
  for (const Move& move : section.moves) {
    const double down = move.z_from - move.z_to;
    if (move.kind != MoveKind::kCut || down <= 0) continue;
    EXPECT_LE(move.feed.mm_per_min() * down / move.length(), 301);
  }
}

/// Ways over square tabs: level, at the feed, on the height of a tab's top, between two passes that end beside it.
int feeds_over(const Section& section, const std::vector<Tab>& tabs) {
  return static_cast<int>(std::count_if(section.moves.begin(), section.moves.end(), [&](const Move& move) {
    return !is_rapid(move.kind) && !move.is_vertical() && move.z_from == move.z_to &&
           std::any_of(tabs.begin(), tabs.end(), [&](const Tab& tab) {
             return distance(move.path, tab.center) < 0.01 && std::abs(move.z_to - tab.top_z - 0.2) < 1e-9;
           });
  }));
}

/// On lines, on arcs bent either way, and in layers below each other.
TEST(SquareTabs, AreFedOverWithinTheKerf) {
  const std::string outlines[] = {box("PROFILE_D6", 0, 0, 80, 50), circle("PROFILE_D6", {0, 0}, 30),
                                  circle("INSIDE_D6", {0, 0}, 30),
                                  rounded_box("PROFILE_D6", 0, 0, 90, 60, 8)};
  for (const std::string& outline : outlines) {
    for (const EntryKind entry : {EntryKind::kPlunge, EntryKind::kRamp}) {
      PlanOptions options = triangular("endmill:4", 3);
      options.tabs.shape = TabShape::kSquare;
      options.entry = entry;
      const auto result = plan_part(drawn(outline), options);
      EXPECT_EQ(faults_of(result.findings), "");
      const Section& section = result.toolpath.sections.back();
      EXPECT_EQ(feeds_over(section, result.part.features.back().profile->tabs), 2);
      EXPECT_EQ(
          std::count_if(section.moves.begin(), section.moves.end(),
                        [](const Move& move) { return is_rapid(move.kind) && move.z_to > move.z_from; }),
          1);
    }
  }
}

TEST(TriangularTabs, WrongProgramsAreFaultyByName) {
  const Part part = drawn(box("PROFILE_D6", 0, 0, 80, 50));
  const auto asked = triangular("endmill:4", 4);
  const auto faults_with = [&](const std::function<void(TabOptions&)>& change) {
    auto other = asked;
    change(other.tabs);
    const auto wrong = plan_part(part, other);
    return faults_of(check_program(part, wrong.program, "wrong.ngc", asked).findings);
  };
  EXPECT_EQ(faults_with([](TabOptions&) {}), "");
  EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.count = 0; }), HasSubstr("missing tab: "));
  EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.height = 1.9; }),
              HasSubstr("stands 1.9 mm high where 2 mm"));
  EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.height = 2.1; }),
              HasSubstr("stands 2.1 mm high where 2 mm"));
  // As high in the middle, and lower beside it.
  EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.width = 3.8; }),
              HasSubstr("tab height: PROFILE_D6_tabs: a side of the triangular tab stands"));
  EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.width = 3.8; }), HasSubstr("mm too low"));
  EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.shape = TabShape::kSquare; }),
              HasSubstr("mm too high"));
}

/// What stands beside a tab because a pass ends too early leaves hardly anything thick in the kerf's corners.
TEST(SquareTabs, TooWideOnesAreFaulty) {
  for (const std::string& outline :
       {box("PROFILE_D6", 0, 0, 80, 50), circle("PROFILE_D6", {0, 0}, 30), circle("INSIDE_D6", {0, 0}, 30)}) {
    auto asked = triangular("endmill:4", 4);
    asked.tabs.shape = TabShape::kSquare;
    auto other = asked;
    other.tabs.width = 4.1;
    const Part part = drawn(outline);
    EXPECT_THAT(faults_of(check_program(part, plan_part(part, other).program, "wide.ngc", asked).findings),
                HasSubstr("uncut: "));
    EXPECT_EQ(faults_of(plan_part(part, asked).findings), "");
  }
}

/// A move across the tab at another place than its middle line.
TEST(TriangularTabs, ACutFromBesideIsSeen) {
  const Part part = drawn(box("PROFILE_D6", 0, 0, 80, 50));
  const auto options = triangular("endmill:4", 4);
  const auto good = plan_part(part, options);
  const Tab& tab = good.part.features.back().profile->tabs.front();
  const auto at = [](double value) { return std::to_string(value); };
  const Vec2 along = tab.foot.tangent_at(0.5), p = tab.center + along * 2.5;
  const std::string cut =
      "G0 Z10\nG0 X" + at(p.x) + " Y" + at(p.y) + "\nG1 Z" + at(tab.bottom_z + 0.7) + " F100\nG0 Z10\n";
  std::string text = good.program;
  text.insert(text.rfind("M5"), cut);
  const auto checked = check_program(part, text, "cut.ngc", options);
  EXPECT_TRUE(has(checked.findings, FaultKind::kTabHeight)) << faults_of(checked.findings);
}

TEST(TabPlaces, AreThoseAskedFor) {
  const Part part = drawn(box("PROFILE_D6", 0, 0, 80, 50));
  for (const TabShape shape : {TabShape::kSquare, TabShape::kTriangular}) {
    auto options = triangular("endmill:4");
    options.tabs.shape = shape;
    options.tabs.at = {{30, -1}, {78, 22}, {41, 53}};
    const auto result = plan_part(part, options);
    EXPECT_EQ(faults_of(result.findings), "");
    const auto& tabs = result.part.features.back().profile->tabs;
    ASSERT_EQ(tabs.size(), 3u);
    const Vec2 centers[] = {{30, -2}, {82, 22}, {41, 52}};
    for (std::size_t i = 0; i < tabs.size(); ++i) EXPECT_LT(distance(tabs[i].center, centers[i]), 1e-6);
    // One of them cut away.
    auto two = options;
    two.tabs.at.pop_back();
    const auto wrong = plan_part(part, two);
    EXPECT_TRUE(has(check_program(part, wrong.program, "two.ngc", options).findings, FaultKind::kMissingTab));
  }
}

std::string refusal_at(const Part& part, const std::vector<Vec2>& places) {
  auto options = triangular("endmill:4");
  options.tabs.at = places;
  try {
    resolve::check(options);
    plan_part(part, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TabPlaces, ThatCannotBeAreRefused) {
  const Part part = drawn(box("PROFILE_D6", 0, 0, 80, 50) + circle("INSIDE_D6", {40, 25}, 5));
  EXPECT_EQ(refusal_at(part, {{40, -3}}), "");
  EXPECT_THAT(refusal_at(part, {{40, -6}}),
              HasSubstr("--tab-at: 40,-6 is 6 mm from the nearest profile, PROFILE_D6"));
  EXPECT_THAT(refusal_at(part, {{2, 0}}), HasSubstr("at 2,0 a corner or a narrow arc of PROFILE_D6"));
  EXPECT_THAT(refusal_at(part, {{2, 0}}), HasSubstr("the nearest place is 8.5,0"));
  EXPECT_THAT(refusal_at(part, {{45, 25}}), HasSubstr("narrow arc of INSIDE_D6"));
  EXPECT_THAT(refusal_at(part, {{30, 0}, {32, 0}}), HasSubstr("another tab is too near"));
  EXPECT_THAT(refusal_at(drawn(box("POCKET_D6", 0, 0, 80, 50)), {{30, 0}}), HasSubstr("no profile"));
}

/// Profiles may be drawn deeper than the stock is thick: tabs and skins stand on its underside nevertheless.
TEST(TabHeights, AreMeasuredFromTheUndersideOfTheStock) {
  const Part part = drawn(box("STOCK_D4", -20, -20, 100, 70) + box("PROFILE_D4.3", 0, 0, 80, 50));
  for (const TabShape shape : {TabShape::kSquare, TabShape::kTriangular}) {
    auto options = triangular("endmill:4", 2);
    options.tabs.shape = shape;
    options.tabs.height = 1.5;
    const auto result = plan_part(part, options);
    EXPECT_EQ(faults_of(result.findings), "");
    for (const Tab& tab : result.part.features.back().profile->tabs) EXPECT_NEAR(tab.top_z, -2.5, 1e-9);
  }
  auto options = triangular("endmill:4");
  options.tabs.skin = 0.3;
  EXPECT_NEAR(plan_part(part, options).part.features.back().floor_z, -3.7, 1e-9);
}

TEST(TabSpacing, IsKeptOrRefused) {
  const Part part = drawn(box("PROFILE_D6", 0, 0, 80, 50));
  auto options = triangular("endmill:4");
  options.tabs.spacing = 65;
  EXPECT_EQ(plan_part(part, options).part.features.back().profile->tabs.size(), 4u);
  options.tabs.spacing = 1000;
  EXPECT_EQ(plan_part(part, options).part.features.back().profile->tabs.size(), 2u);
  options.tabs.spacing = 8;
  EXPECT_THROW(plan_part(part, options), InputError);
  options.tabs.count = 3;
  EXPECT_THROW(resolve::check(options), InputError);
}

}  // namespace
}  // namespace clearcut::pipeline
