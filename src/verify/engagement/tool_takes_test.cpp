// What reamers, boring bars and taps may go down into.
#include <gtest/gtest.h>

#include <optional>

#include "verify/test_findings.h"
#include "verify/verify.h"

namespace clearcut::verify {
namespace {

using namespace clearcut::testing;

/// A tool of 10 mm, fed to `z` in the middle of a square, where before a drill of that diameter went down with its point to
/// `drilled`; no drill for 0. The block ends at `bottom`, if that is stated.
Findings fed_down(ToolKind kind, double z, double diameter, double drilled,
                  std::optional<double> bottom = std::nullopt) {
  Part part = square_part();
  if (bottom) part.stock = Stock{{{0, 0}, {50, 50}}, *bottom, 0};
  part.tools[0] = Tool{1, "T1", kind, 10, 0, 2, {}, true};
  part.tools[0].pitch = 1.5;
  part.tools.push_back(Tool{2, "T2", ToolKind::kDrill, diameter, 0, 2, {}, true});
  Writer writer(2);
  if (drilled < 0) writer.enter({25, 25}, 0, drilled).feed({25, 25}, 1, 300).leave();
  writer.tool_change(1).enter({25, 25}, 0, z).feed({25, 25}, 1, 300);
  return verify_program(part, writer.done(), {});
}

TEST(ToolTakes, NothingSolidUnderTheTipHoweverShallow) {
  for (const ToolKind kind : {ToolKind::kReamer, ToolKind::kBoringBar, ToolKind::kTap}) {
    for (const double z : {-0.2, -1.0, -3.0}) {
      const bool is_said = has(fed_down(kind, z, 0, 0), FaultKind::kMoreThanItCuts);
      EXPECT_TRUE(is_said) << name_of(kind) << " " << z;
    }
    EXPECT_TRUE(has(fed_down(kind, -8, 9.6, -5), FaultKind::kMoreThanItCuts)) << name_of(kind);
    EXPECT_TRUE(has(fed_down(kind, -8, 7, -9), FaultKind::kMoreThanItCuts)) << name_of(kind);
    // As deep as the drill: its point leaves a cone in the corner of the hole.
    EXPECT_FALSE(has(fed_down(kind, -8, 9.6, -8), FaultKind::kMoreThanItCuts)) << name_of(kind);
  }
}

TEST(ToolTakes, NothingStandsBelowTheBlock) {
  for (const ToolKind kind : {ToolKind::kReamer, ToolKind::kBoringBar, ToolKind::kTap}) {
    // The drill's whole width has left the block by 0.1 mm.
    EXPECT_FALSE(has(fed_down(kind, -12, 9.6, -8, -5), FaultKind::kMoreThanItCuts)) << name_of(kind);
    EXPECT_TRUE(has(fed_down(kind, -12, 9.6, -8), FaultKind::kMoreThanItCuts)) << name_of(kind);
    // Its point alone has: a cone of the wall's foot stands in the block.
    EXPECT_TRUE(has(fed_down(kind, -12, 9.6, -6, -5), FaultKind::kMoreThanItCuts)) << name_of(kind);
    EXPECT_TRUE(has(fed_down(kind, -12, 9.6, -4.5, -5), FaultKind::kMoreThanItCuts)) << name_of(kind);
  }
}

TEST(ToolTakes, DrillsGoDownAlongTheirAxisHoweverSteep) {
  Part part = square_part();
  part.tools[0] = Tool{1, "T1", ToolKind::kDrill, 10, 0, 2, {}, true};
  const auto ramp = [&](double aside) {
    Writer writer;
    writer.enter({20, 25}, 0, -2).feed({20 + aside, 25}, -4, 100).feed({20 + aside, 25}, 5, 100);
    return verify_program(part, writer.done(), {});
  };
  EXPECT_TRUE(has(ramp(2), FaultKind::kMoreThanItCuts));
  EXPECT_TRUE(has(ramp(0.3), FaultKind::kMoreThanItCuts));
  EXPECT_FALSE(has(ramp(0.01), FaultKind::kMoreThanItCuts));
}

TEST(ToolTakes, FlatTipsOfChamferMillsDoNotSinkIntoMaterial) {
  Part part = square_part();
  part.tools[0] = Tool{1, "T1", ToolKind::kChamferMill, 10, 0, 2, {}, true};
  part.tools[0].tip_angle = Radians::of_degrees(90);
  part.tools[0].tip_diameter = 4;
  const auto way = [&](double from, double to) {
    Writer writer;
    writer.rapid({-20, 25}, 10).rapid({-20, 25}, from).feed({5, 25}).feed({25, 25}, to, 100);
    return has(verify_program(part, writer.done(), {}), FaultKind::kMoreThanItCuts);
  };
  EXPECT_TRUE(way(0, -2));
  EXPECT_TRUE(way(0, -8));
  EXPECT_FALSE(way(-2, -2));
  EXPECT_FALSE(way(-2, -2.2));
}

}  // namespace
}  // namespace clearcut::verify
