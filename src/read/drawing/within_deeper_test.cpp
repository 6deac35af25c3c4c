// What lies in a pocket as deep as itself or deeper is asked about.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "base/text.h"
#include "geometry/region.h"
#include "read/drawing/layer_rules.h"
#include "read/job/read_part.h"

namespace clearcut::read {
namespace {

using ::testing::HasSubstr;

struct Rectangle {
  double x0, y0, x1, y1;
  friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

std::string drawn(const std::string& layer, const Rectangle& r) {
  const std::array corners{Vec2{r.x0, r.y0}, Vec2{r.x1, r.y0}, Vec2{r.x1, r.y1}, Vec2{r.x0, r.y1}};
  std::string text = "0 LWPOLYLINE 8 " + layer + " 90 4 70 1";
  for (const Vec2 p : corners) text += " 10 " + trimmed(p.x, 6) + " 20 " + trimmed(p.y, 6);
  return text + " ";
}

Part part_of(const std::string& entities, const ReadOptions& options) {
  std::string text =
      "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 ENTITIES " + entities + "0 ENDSEC 0 EOF ";
  std::replace(text.begin(), text.end(), ' ', '\n');
  return read_part_text(text, "steps.dxf", options);
}

Part part_of(const std::string& entities, bool asks = false) {
  ReadOptions options;
  options.ask_if_unclear = asks;
  return part_of(entities, options);
}

std::string overview_question(const std::string& entities) {
  DrawingOverview overview;
  ReadOptions options;
  options.ask_if_unclear = true;
  options.overview = &overview;
  part_of(entities, options);
  return overview.question;
}

/// The question; "" where none is asked.
std::string asked(const std::string& entities) {
  try {
    part_of(entities, true);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(WithinDeeper, ASteppedPocketIsDrawnWithItsOutlineOnBothLayers) {
  const Rectangle outer{0, 0, 60, 40}, step{10, 10, 40, 20};
  const Part part =
      part_of(drawn("POCKET_D5", outer) + drawn("POCKET_D5", step) + drawn("POCKET_D2", step), true);
  ASSERT_EQ(part.features.size(), 2U);
  EXPECT_NEAR(area(part.features[0].target), 300, 1e-9);
  EXPECT_NEAR(area(part.features[1].target), 2100, 1e-9);
  EXPECT_THAT(asked(drawn("POCKET_D5", outer) + drawn("POCKET_D2", step)),
              HasSubstr("POCKET_D2 is 2 mm deep and lies in a pocket of layer POCKET_D5, which takes all of "
                        "it away: --op step:POCKET_D2 if it is a step that stays in that pocket; --op "
                        "ignore:POCKET_D2 leaves it out"));
  EXPECT_EQ(asked(drawn("POCKET_D2", outer) + drawn("POCKET_D5", step)), "");
}

/// Area by depth below the top.
std::map<double, double> areas_of(const std::string& entities, const std::vector<std::string>& answers) {
  ReadOptions options;
  options.ask_if_unclear = true;
  for (const std::string& answer : answers) options.layer_rules.push_back(rule_of_option(answer, "--op"));
  std::map<double, double> areas;
  for (const Feature& feature : part_of(entities, options).features)
    areas[std::round(-1e6 * feature.floor_z) / 1e6] += std::round(1e6 * area(feature.target)) / 1e6;
  return areas;
}

TEST(WithinDeeper, BothAnswersToItsQuestionAreUnderstood) {
  const std::string pocket = drawn("POCKET_D5", {0, 0, 60, 40}), step = drawn("POCKET_D2", {10, 10, 40, 20});
  using Areas = std::map<double, double>;
  EXPECT_EQ(areas_of(pocket + step, {"step:POCKET_D2"}), (Areas{{2, 300}, {5, 2100}}));
  EXPECT_EQ(areas_of(pocket + step, {"ignore:POCKET_D2"}), (Areas{{5, 2400}}));
  EXPECT_EQ(areas_of(pocket + step, {"step_d3:2"}), (Areas{{3, 300}, {5, 2100}}));
}

TEST(WithinDeeper, StepsStandInStepsAndAcrossWalls) {
  const std::string pocket = drawn("POCKET_D9", {0, 0, 60, 40}), low = drawn("LOW_D6", {10, 10, 40, 30});
  const std::string high = drawn("HIGH_D2", {20, 15, 30, 25}), across = drawn("HIGH_D2", {50, 10, 80, 20});
  const std::string hole = drawn("POCKET_D12", {22, 18, 28, 22});
  using Areas = std::map<double, double>;
  EXPECT_EQ(areas_of(pocket + low + high, {"step:LOW*", "step:HIGH*"}),
            (Areas{{2, 100}, {6, 500}, {9, 1800}}));
  EXPECT_EQ(areas_of(pocket + across, {"step:HIGH*"}), (Areas{{2, 300}, {9, 2300}}));
  // What lies wholly in a step is cut in it.
  EXPECT_EQ(areas_of(pocket + high + hole, {"step:HIGH*"}), (Areas{{2, 100}, {9, 2300}, {12, 24}}));
}

TEST(WithinDeeper, TheOverviewAsksTheSame) {
  const std::string entities = drawn("POCKET_D5", {0, 0, 60, 40}) + drawn("POCKET_D2", {10, 10, 40, 20});
  EXPECT_THAT(asked(entities), HasSubstr(overview_question(entities)));
  EXPECT_THAT(overview_question(entities), HasSubstr("POCKET_D2 is 2 mm deep and lies in a pocket"));
  EXPECT_EQ(overview_question(drawn("POCKET_D2", {0, 0, 60, 40}) + drawn("POCKET_D5", {10, 10, 40, 20})), "");
  EXPECT_EQ(overview_question(drawn("POCKET", {0, 0, 60, 40}) + drawn("POCKET_D2", {10, 10, 40, 20})), "");
}

/// Any two rectangles: it is asked exactly where the one that is no deeper lies in the other.
TEST(WithinDeeper, ItIsAskedOnlyWhereNothingWouldBeLeft) {
  Random random(11);
  int questions = 0;
  for (int round = 0; round < 400; ++round) {
    const auto any = [&] {
      const double x = static_cast<double>(random.below(6)), y = static_cast<double>(random.below(6));
      return Rectangle{x, y, x + 2 + static_cast<double>(random.below(6)),
                       y + 2 + static_cast<double>(random.below(6))};
    };
    const Rectangle first = any(), second = any();
    const int one = 1 + static_cast<int>(random.below(5)), other = 1 + static_cast<int>(random.below(5));
    if (one == other || first == second) continue;
    const Rectangle &shallow = one < other ? first : second, &deep = one < other ? second : first;
    const bool nothing_left =
        shallow.x0 >= deep.x0 && shallow.y0 >= deep.y0 && shallow.x1 <= deep.x1 && shallow.y1 <= deep.y1;
    const std::string text = asked(drawn("A_POCKET_D" + std::to_string(one), first) +
                                   drawn("B_POCKET_D" + std::to_string(other), second));
    EXPECT_EQ(!text.empty(), nothing_left) << round << " " << text;
    questions += nothing_left ? 1 : 0;
  }
  EXPECT_GT(questions, 10);
}

TEST(WithinDeeper, WhatAPocketWouldCutAwayIsAskedAbout) {
  const std::array<const char*, 3> layers{"VCARVE_D1", "INSIDE_D3", "PROFILE_D5"};
  for (const char* layer : layers) {
    const std::string text = drawn("POCKET_D5", {0, 0, 60, 40}) + drawn(layer, {10, 10, 40, 20});
    try {
      part_of(text, true);
      FAIL() << layer;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("which takes all of it away")) << layer;
    }
    // Where nobody can be asked it is said.
    std::string said;
    const Part part = part_of(text);
    for (const Diagnostic& item : part.diagnostics.items()) said += item.what + "\n";
    EXPECT_THAT(said, HasSubstr("which takes all of it away")) << layer;
  }
  EXPECT_NO_THROW(part_of(drawn("POCKET_D5", {0, 0, 60, 40}) + drawn("PROFILE_D8", {10, 10, 40, 20}), true));
  EXPECT_NO_THROW(
      part_of(drawn("POCKET_D5", {0, 0, 60, 40}) + drawn("VCARVE_TOP-5_D1", {10, 10, 40, 20}), true));
}

}  // namespace
}  // namespace clearcut::read
