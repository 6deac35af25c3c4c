// Feeds and speeds that no cutter bears.
#include <gtest/gtest.h>

#include "verify/faults/faults.h"
#include "verify/test_program.h"
#include "verify/verify.h"

namespace clearcut::verify {
namespace {

using namespace clearcut::testing;

/// Conditions of a pocket that is cut by `tool` at these values, "" where there are none.
std::string conditions_of(const Tool& tool, double feed, double rpm, const VerifyOptions& asked = {}) {
  Part part = pocket_part(rectangle(-20, -20, 20, 20), tool.diameter, -2);
  part.tools[0] = tool;
  Writer writer;
  writer.enter({-5, 0}, 0, -2).feed({5, 0}, -2, feed).feed({5, 5}, -2, feed);
  ControlState state;
  state.tool = 1;
  state.spindle = SpindleState::kClockwise;
  state.spindle_rpm = rpm;
  state.path.mode = PathMode::kExactPath;
  ControlTable control;
  control.spans.push_back({0, 1, state});
  VerifyOptions options = asked;
  options.control = &control;
  std::string names;
  for (const Condition& one : verify_program(part, writer.done(), options).conditions)
    names += (names.empty() ? "" : " ") + one.name;
  return names;
}

Tool cutter(double diameter, int teeth = 2, ToolKind kind = ToolKind::kEndMill) {
  Tool tool;
  tool.kind = kind;
  tool.diameter = diameter;
  tool.teeth = teeth;
  return tool;
}

TEST(CuttingData, ThatNoCutterBearsIsACondition) {
  EXPECT_EQ(conditions_of(cutter(6), 400, 8000), "");
  EXPECT_EQ(conditions_of(cutter(6), 400, 50), "chip-load") << "4 mm a tooth";
  EXPECT_EQ(conditions_of(cutter(6), 60000, 8000), "chip-load");
  EXPECT_EQ(conditions_of(cutter(6), 900, 500), "chip-load") << "0.9 mm a tooth";
  EXPECT_EQ(conditions_of(cutter(6), 1, 8000), "chip-load") << "rubs";
  EXPECT_EQ(conditions_of(cutter(6), 400, 500000), "cutting-speed");
  EXPECT_EQ(conditions_of(cutter(0.2), 1000, 500000), "cutting-speed") << "no spindle turns so fast";
}

TEST(CuttingData, OfOrdinaryWorkIsNone) {
  EXPECT_EQ(conditions_of(cutter(6), 6000, 24000), "") << "a router in foam";
  EXPECT_EQ(conditions_of(cutter(25), 9000, 18000), "") << "surfacing of boards";
  EXPECT_EQ(conditions_of(cutter(0.1), 400, 10000), "") << "engraving needle";
  EXPECT_EQ(conditions_of(cutter(0.3), 20, 24000), "") << "micro milling";
  EXPECT_EQ(conditions_of(cutter(16, 1), 3000, 24000), "") << "one tooth in plastics";
  EXPECT_EQ(conditions_of(cutter(20, 3), 7000, 1600), "") << "inserts for high feeds";
  EXPECT_EQ(conditions_of(cutter(63, 5, ToolKind::kFaceMill), 800, 300), "");
}

TEST(CuttingData, AnSWordThatMayBeAPowerSaysNothing) {
  VerifyOptions power;
  power.speed_may_be_power = true;
  EXPECT_EQ(conditions_of(cutter(6), 600, 100, power), "");
  EXPECT_EQ(conditions_of(cutter(6), 600, 100), "chip-load");
  EXPECT_EQ(conditions_of(cutter(6), 60000, 8000, power), "chip-load");
}

TEST(CuttingData, FarFromWhatIsStatedForTheTool) {
  VerifyOptions stated;
  stated.stated[1] = {400, 8000, 10000};
  EXPECT_EQ(conditions_of(cutter(6), 500, 12000, stated), "");
  EXPECT_EQ(conditions_of(cutter(6), 700, 12000, stated), "stated-feed");
  EXPECT_EQ(conditions_of(cutter(6), 400, 16000, stated), "stated-speed");
  EXPECT_EQ(conditions_of(cutter(6), 400, 3000, stated), "stated-speed");
  stated.stated[1] = {};
  EXPECT_EQ(conditions_of(cutter(6), 700, 3000, stated), "") << "nothing is stated";
}

TEST(CuttingData, TapsTurnAsIsStatedForThem) {
  Tool tap = cutter(6, 2, ToolKind::kTap);
  tap.pitch = 1;
  tap.floating = true;
  VerifyOptions stated;
  stated.stated[1] = {400, 400, 400};
  EXPECT_EQ(conditions_of(tap, 400, 400, stated), "");
  EXPECT_EQ(conditions_of(tap, 900, 900, stated), "stated-speed") << "its feed follows its speed";
}

}  // namespace
}  // namespace clearcut::verify
