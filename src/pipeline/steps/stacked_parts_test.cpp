// Features over, under and across one another: whatever one step leaves and another takes, no rapid may meet it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/random.h"
#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

/// The whole range of what is tried: CLEARCUT_RANDOM_PARTS parts instead of `usual`.
int count_of(int usual) {
  const char* set = std::getenv("CLEARCUT_RANDOM_PARTS");
  return set ? std::atoi(set) : usual;
}

std::string turned(const std::string& layer, std::vector<BulgeVertex> vertices, Vec2 center, double angle) {
  const Vec2 x = direction_of(angle), y = left_of(x);
  for (BulgeVertex& v : vertices) v.point = center + x * v.point.x + y * v.point.y;
  return outline(layer, vertices);
}

std::vector<BulgeVertex> star(double radius, Random& random, double bulge) {
  std::vector<BulgeVertex> vertices;
  const int corners = 4 + static_cast<int>(random.below(5));
  for (int i = 0; i < corners; ++i) {
    const double r = radius * random.between(0.7, 1);
    vertices.push_back({direction_of(2 * kPi * i / corners) * r, random.below(2) ? bulge : 0});
  }
  return vertices;
}

/// An outline about as wide as `size`, mm: a circle, box, slot, or star of lines or arcs.
std::string shape(const std::string& layer, Vec2 center, double size, Random& random) {
  const double half = size / 2, low = half * random.between(0.5, 1);
  const double angle = random.below(2) ? 0 : random.between(0, kPi);
  switch (random.below(6)) {
    case 0:
      return turned(layer, {{{-half, -low}}, {{half, -low}}, {{half, low}}, {{-half, low}}}, center, angle);
    case 1:
      return turned(layer,
                    {{{-half / 2, -half / 2}},
                     {{half / 2, -half / 2}, 1},
                     {{half / 2, half / 2}},
                     {{-half / 2, half / 2}, 1}},
                    center, angle);
    case 2:
      return turned(layer, star(half, random, 0), center, 0);
    case 3:
      return turned(layer, star(half, random, 0.2), center, 0);
    default:
      return circle(layer, center, half);
  }
}

struct Stack {
  std::string entities;
  PlanOptions options;
  std::string told;  ///< what to repeat where it fails
};

/// mm. Where the feature of a stack lies: about one axis, a little or far apart, or on whole numbers.
Vec2 place(std::uint64_t kind, Random& random) {
  if (kind < 2) return {};
  const double apart = kind == 2 ? 10 : 22;
  const Vec2 p{random.between(-apart, apart), random.between(-apart, apart)};
  return kind == 3 ? p : Vec2{std::round(p.x), std::round(p.y)};
}

Stack random_stack(std::uint64_t seed, const std::string& strategy) {
  Random random(seed);
  Stack stack;
  const std::uint64_t kind = random.below(4), features = 2 + random.below(3);
  for (std::uint64_t i = 0; i < features; ++i) {
    const bool whole = kind == 0 || random.below(2) == 0;
    double size = random.between(13, 48);
    if (whole) size = std::round(size / 2) * 2;
    const std::string layer =
        std::string(1, static_cast<char>('A' + i)) + "_POCKET_D" + std::to_string(1 + random.below(9));
    stack.entities += shape(layer, place(kind, random), size, random);
  }
  std::vector<std::string> tools;
  const int first = 3 + static_cast<int>(random.below(4));
  tools.push_back("endmill:" + std::to_string(first));
  if (random.below(3) == 0) tools.push_back("endmill:" + std::to_string(first + 2));
  if (random.below(4) == 0) tools.push_back("endmill:" + std::to_string(first + 4));
  stack.options = with(tools);
  if (random.below(2) == 0) stack.options.stepdown = 1 + static_cast<double>(random.below(4));
  if (strategy != "auto") stack.options.strategy = strategy;
  if (random.below(4) == 0) stack.options.allowance = 0.1 * static_cast<double>(1 + random.below(4));
  const EntryKind entries[] = {EntryKind::kPlunge, EntryKind::kRamp, EntryKind::kHelix};
  if (random.below(2) == 0) stack.options.entry = entries[random.below(3)];
  stack.told = strategy + " " + std::to_string(seed);
  return stack;
}

void expect_no_fault(const Stack& stack) {
  SCOPED_TRACE(stack.told);
  try {
    const PlanResult result = plan_part(drawn(stack.entities), stack.options);
    EXPECT_EQ(faults_of(result.findings), "") << drawing(stack.entities);
  } catch (const InputError& refused) {
    ADD_FAILURE() << refused.what();
  }
}

class StackedParts : public ::testing::TestWithParam<std::pair<const char*, int>> {};

TEST_P(StackedParts, AreNeverFaulty) {
  const auto [strategy, usual] = GetParam();
  for (int i = 1; i <= count_of(usual); ++i)
    expect_no_fault(random_stack(static_cast<std::uint64_t>(i), strategy));
}

INSTANTIATE_TEST_SUITE_P(Strategies, StackedParts,
                         ::testing::Values(std::pair{"auto", 40}, std::pair{"contour", 100},
                                           std::pair{"zigzag", 100}, std::pair{"spiral", 60},
                                           std::pair{"adaptive", 25}),
                         [](const auto& one) { return std::string(one.param.first); });

/// The outer ring of a fast candidate leaves a post of the cutter's width in the middle, over what is cut later.
TEST(StackedFeatures, APocketOverADeeperHoleLeavesNoPost) {
  const Part part = drawn(circle("POCKET_D3", {}, 20) + circle("HOLE_D10", {}, 15));
  PlanOptions options = with({"endmill:8"});
  options.stepdown = 3;
  EXPECT_EQ(faults_of(plan_part(part, options).findings), "");
}

TEST(StackedFeatures, APocketThatADeeperOneTakesWholeIsCutAllTheSame) {
  const Part part = drawn(circle("A_POCKET_D2", {2, -4}, 8) + circle("B_POCKET_D8", {4, -1}, 17.5));
  PlanOptions options = with({"endmill:3"});
  options.strategy = "contour";
  EXPECT_EQ(faults_of(plan_part(part, options).findings), "");
}

/// Stock stays on walls; where a pocket takes the wall of a hole away, nothing of the hole stays.
TEST(StackedFeatures, NoStockStaysOnAWallThatAnotherFeatureTakesAway) {
  const std::string shapes = circle("A_HOLE_D3", {}, 19.11) + box("B_POCKET_D8", -12, -10, 12, 29);
  for (const char* strategy : {"contour", "zigzag", "auto"}) {
    PlanOptions options = with({"endmill:8"});
    if (std::string(strategy) != "auto") options.strategy = strategy;
    options.allowance = 0.2;
    EXPECT_EQ(faults_of(plan_part(drawn(shapes), options).findings), "") << strategy;
  }
}

/// The deep pocket's wide cutter does not come between the walls where the shallow one's narrow cutter does: the floor there is
/// finished by that one.
TEST(StackedFeatures, AFloorIsFinishedWhereTheDeeperPocketsCutterCannotReach) {
  const Part part =
      drawn(circle("B_POCKET_D4", {}, 10) + circle("C_POCKET_D8", {}, 16) + box("ISLAND", 3, -3, 9.5, 3));
  PlanOptions options = with({"endmill:10", "endmill:5"});
  options.strategy = "contour";
  options.shop.finish = "floor";
  EXPECT_EQ(faults_of(plan_part(part, options).findings), "");
}

/// The wide cutter clears the box in one layer below the floor of the round pocket in it, which bounds it there. The narrow
/// cutter's first layer lies above that floor, where the wide one would have had more room.
TEST(StackedFeatures, ANarrowCutterTakesWhatTheDeeperLayerOfAWiderOneLeftAbove) {
  const Part part = drawn(circle("A_POCKET_D3", {}, 10) + circle("B_POCKET_D4", {}, 10) +
                          box("B_POCKET_D4", -24, -13, 24, 13) + circle("C_POCKET_D8", {}, 10) +
                          circle("C_POCKET_D8", {}, 12));
  for (const char* strategy : {"contour", "zigzag"}) {
    PlanOptions options = with({"endmill:6", "endmill:8"});
    options.strategy = strategy;
    EXPECT_EQ(faults_of(plan_part(part, options).findings), "") << strategy;
  }
}

}  // namespace
}  // namespace clearcut::pipeline
