// Solids of blocks side by side, whose floors lie where the test put them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "pipeline/run.h"
#include "read/read_part.h"
#include "support/plans.h"
#include "support/solids.h"
#include "support/stepped_solid.h"

namespace clearcut {
namespace {

using test_support::step_text;
using test_support::SteppedSolid;
using test_support::with_tool;

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
        const pipeline::PlanResult result = pipeline::plan_part(part, with_tool(diameter));
        EXPECT_NE(verdict_of(result.findings), Verdict::kFaulty);
      }
    }
  }
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

}  // namespace
}  // namespace clearcut
