// Solids of blocks side by side, whose floors lie where the test put them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "base/elementary.h"
#include "base/units.h"
#include "pipeline/run.h"
#include "read/job/read_part.h"
#include "support/plans.h"
#include "support/solids.h"
#include "support/stepped_solid.h"

namespace clearcut {
namespace {

using test_support::refusal;
using test_support::step_text;
using test_support::SteppedSolid;
using test_support::with_tool;
using ::testing::HasSubstr;

/// A pocket of 10 x 6 mm in a block of 10 mm, and a second one in its right half.
std::string nested(double depth, double below) {
  const double top = 7.49, first = top - depth, second = first - below;
  return step_text({{0, 5, 10, 15, 20},
                    {0, 5, 11, 16},
                    {{top, top, top, top}, {top, first, second, top}, {top, top, top, top}},
                    top - 10});
}

/// Floors on both sides of every tolerance: what is too low for a cutter to follow is left out, never a fault.
TEST(SteppedSolids, FloorsThinnerThanTolerancesAreNoFaults) {
  SKIP_WITHOUT_OPEN_CASCADE();
  constexpr double kThin = 0.00101;  // what counts as no gouge, and rounding
  for (const double depth : {0.0005, 0.0009, 0.001, 0.00102, 0.0015, 0.005, 0.01, 0.0101, 0.5}) {
    for (const double below : {0.01, 1.0}) {
      const Part part = read::read_part_text(nested(depth, below), "nested.step", {});
      ASSERT_EQ(part.features.size(), depth > kThin ? 2U : 1U) << depth << " " << below;
      for (const double diameter : {2.0, 4.0}) {
        SCOPED_TRACE(std::to_string(depth) + " " + std::to_string(below) + " " + std::to_string(diameter));
        const PlanResult result = pipeline::plan_part(part, with_tool(diameter));
        EXPECT_NE(verdict_of(result.findings), Verdict::kFaulty);
      }
    }
  }
}

/// A wall whose foot lies at two heights is reached from above at each of them.
TEST(SteppedSolids, AWallWithAFootAtTwoHeightsIsMadeFromAbove) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const Part part = read::read_part_text(test_support::stepped_foot_text(), "foot.step", {});
  EXPECT_EQ(part.features.size(), 2U);
  for (const Diagnostic& item : part.diagnostics.items()) EXPECT_EQ(item.condition, "") << item.what;
}

/// A hollow smaller than any cutter is not called hidden.
TEST(SteppedSolids, AFloorTooSmallToBeCutIsCalledSmall) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const Part part = read::read_part_text(
      step_text({{0, 5, 15, 20, 20.09, 30},
                 {0, 5, 5.09, 15, 20},
                 {{10, 10, 10, 10, 10}, {10, 10, 10, 7, 10}, {10, 6, 10, 10, 10}, {10, 10, 10, 10, 10}},
                 0}),
      "speck.step", {});
  std::string doubts;
  for (const Diagnostic& item : part.diagnostics.items())
    if (!item.condition.empty()) doubts += item.what + "\n";
  EXPECT_THAT(doubts, HasSubstr("smaller than 0.01 mm2 and left out"));
}

/// Without a floor, too, a cone at hand breaks the edges.
TEST(SteppedSolids, BrokenEdgesAloneAreMilledByACone) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const std::string block = test_support::broken_block_text(40, 30, 10, 1);
  EXPECT_THAT(refusal(block),
              HasSubstr("a cone of 90 degrees, long and wide enough, breaks the edges of faces"));
  ReadOptions options;
  const PlanOptions cone = test_support::plan_options_with({"chamfer:6:90deg"});
  options.solid.tools = cone.tools;
  const Part part = read::read_part_text(block, "block.step", options);
  ASSERT_EQ(part.features.size(), 1U);
  EXPECT_EQ(part.features[0].kind, FeatureKind::kChamfer);
  const PlanResult result = pipeline::plan_part(part, cone);
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean);
}

TEST(SteppedSolids, WhatIsTooLowForACutIsNamed) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const Part part = read::read_part_text(nested(0.5, 0.0005), "nested.step", {});
  ASSERT_EQ(part.features.size(), 1U);
  EXPECT_NEAR(area(part.features[0].target), 60, 1e-6);
  const auto& said = part.diagnostics.items();
  EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](const Diagnostic& item) {
    return item.what.find("lies 0.0005 mm below what is around it") != std::string::npos;
  }));
}

/// Floors there are, so "no floor looks up" would send their owner looking for what is not wrong.
TEST(SteppedSolids, FloorsThatAreAllTooLowAreTheReasonOfTheRefusal) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const std::string text =
      step_text({{0, 5, 10, 15}, {0, 5, 11, 16}, {{7, 7, 7}, {7, 6.9992, 7}, {7, 7, 7}}, 0});
  const std::string message = refusal(text);
  EXPECT_THAT(message, HasSubstr("its floors lie at most 0.0008 mm below what is around them"));
}

/// The same file with every point and direction turned, about X where `first` is 1, about Z where it is 0.
std::string turned(const std::string& text, std::size_t first, double degrees) {
  const double sine = base::sin(degrees * kPi / 180), cosine = base::cos(degrees * kPi / 180);
  std::string out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("('',(");
    double p[3];
    if (at != std::string::npos &&
        std::sscanf(line.c_str() + at, "('',(%lf,%lf,%lf))", &p[0], &p[1], &p[2]) == 3) {
      const double a = p[first], b = p[first + 1];
      p[first] = cosine * a - sine * b;
      p[first + 1] = sine * a + cosine * b;
      line = line.substr(0, at) + fmt::format("('',({:.12f},{:.12f},{:.12f}));", p[0], p[1], p[2]);
    }
    out += line + "\n";
  }
  return out;
}

TEST(SteppedSolids, ThatLieAskewAreRefusedWithTheirFlattestSide) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const std::string text = nested(2, 3);
  for (const double degrees : {0.01, 37.0}) {
    const std::string message = refusal(turned(text, 1, degrees));
    EXPECT_THAT(message, HasSubstr("the solid lies askew")) << degrees;
    EXPECT_THAT(message, HasSubstr("turn the solid with --up face")) << degrees;
  }
  ReadOptions options;
  const std::string askew = turned(text, 1, 37);
  const std::string message = refusal(askew);
  const std::size_t at = message.find("--up face") + 5;
  options.solid.up = message.substr(at, message.find(' ', at) - at);
  const Part part = read::read_part_text(askew, "askew.step", options);
  ASSERT_EQ(part.features.size(), 2U);
  EXPECT_NEAR(area(part.features[0].target), 60, 1e-4);
  EXPECT_NEAR(part.features[1].top_z - part.features[1].floor_z, 3, 1e-6);
}

TEST(SteppedSolids, SheetsOnTheirEdgesAreKnownHoweverTheyStand) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const std::string sheet = step_text({{0, 30, 60, 90}, {0, 3}, {{60, 50, 60}}});
  for (const double degrees : {0.0, 45.0, 10.0}) {
    const std::string message = refusal(turned(sheet, 0, degrees));
    EXPECT_THAT(message, HasSubstr("a sheet of 3 mm stands on its edge")) << degrees;
    EXPECT_THAT(message, HasSubstr(degrees == 0 ? "Y)" : "--up face")) << degrees;
    EXPECT_THAT(message, HasSubstr("(--up +Z if that is meant)")) << degrees;
  }
}

/// Every "--up SIDE" of a message.
std::vector<std::string> proposed(const std::string& message) {
  std::vector<std::string> sides;
  for (std::size_t at = message.find("--up "); at != std::string::npos; at = message.find("--up ", at + 5))
    sides.push_back(message.substr(at + 5, message.find_first_of(" );", at + 5) - at - 5));
  return sides;
}

/// A block with a pocket in its smallest face, which looks along Y after a quarter turn.
TEST(SteppedSolids, ASmallSideWithTheOnlyFloorIsProposed) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const std::string block =
      step_text({{0, 3, 9, 12}, {0, 5, 35, 40}, {{50, 50, 50}, {50, 44, 50}, {50, 50, 50}}});
  const std::string message = refusal(turned(block, 1, 90));
  const std::vector<std::string> sides = proposed(message);
  ASSERT_EQ(sides.size(), 1U) << message;
  EXPECT_EQ(sides[0].back(), 'Y') << message;
}

/// Sheets with a notch in their edge, without one, and with steps, as they lie and turned: no side is proposed in vain.
TEST(SteppedSolids, SidesThatAreProposedForASheetAreMilled) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const std::string notched = step_text({{0, 30, 60, 90}, {0, 3}, {{60, 50, 60}}});
  const std::string plain = step_text({{0, 90}, {0, 3}, {{60}}});
  const std::string stepped = step_text({{0, 30, 90}, {0, 3}, {{60, 59.9}}});
  for (const std::string& sheet : {notched, plain, stepped}) {
    for (const double degrees : {0.0, 30.0}) {
      const std::string text = turned(sheet, 0, degrees);
      for (const std::string& side : proposed(refusal(text))) {
        ReadOptions options;
        options.solid.up = side;
        EXPECT_NO_THROW(read::read_part_text(text, "sheet.step", options)) << side << " " << degrees;
      }
    }
  }
}

}  // namespace
}  // namespace clearcut
