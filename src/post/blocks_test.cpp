// The texts of Sinumerik's cycles.
#include "post/blocks.h"

#include <gtest/gtest.h>

namespace clearcut::post {
namespace {

DrillBlock hole(DrillForm form, const PrintGrid& grid, double peck = 0) {
  DrillBlock block;
  block.form = form;
  block.bottom = grid.ticks(Vec2{5, 6}, -8);
  block.clear = grid.ticks(1);
  block.above = grid.ticks(10);
  block.peck = grid.ticks(peck);
  block.feed = MmPerMin::of(120);
  return block;
}

std::string call(DrillForm form, double dwell = 0, double peck = 0) {
  const PrintGrid grid(false, 3);
  const DrillBlock block = hole(form, grid, peck);
  return cycle_call({block, nullptr, 3000, true, dwell}, grid, false);
}

std::string tap_call(bool floating, bool left_hand, bool inch = false) {
  const PrintGrid grid(inch, inch ? 4 : 3);
  const DrillBlock block = hole(DrillForm::kFeedsOut, grid);
  Tool tap;
  tap.kind = ToolKind::kTap;
  tap.pitch = 1.27;
  tap.floating = floating;
  tap.left_hand = left_hand;
  return cycle_call({block, &tap, 500, !left_hand}, grid, inch);
}

TEST(CycleCall, StatesHeightsAndWhatTheFormNeeds) {
  EXPECT_EQ(call(DrillForm::kAtOnce), "MCALL CYCLE81(10,1,0,-8)");
  EXPECT_EQ(call(DrillForm::kAtOnce, 0.5), "MCALL CYCLE82(10,1,0,-8,,0.5)");
  EXPECT_EQ(call(DrillForm::kPecks, 0, 2.5), "MCALL CYCLE83(10,1,0,-8,,-1.5,,0,,,1,1,,2.5,,,0.254)");
  EXPECT_EQ(call(DrillForm::kFeedsOut), "MCALL CYCLE85(10,1,0,-8,,,120,120)");
}

TEST(CycleCall, StatesPitchAndHandOfTaps) {
  EXPECT_EQ(tap_call(false, false), "MCALL CYCLE84(10,1,0,-8,,,3,,1.27,0,500,500)");
  EXPECT_EQ(tap_call(false, true), "MCALL CYCLE84(10,1,0,-8,,,4,,-1.27,0,500,500)");
  EXPECT_EQ(tap_call(false, false, true), "MCALL CYCLE84(0.3937,0.0394,0,-0.315,,,3,,0.05,0,500,500)");
  EXPECT_EQ(tap_call(true, false), "MCALL CYCLE840(10,1,0,-8,,,4,3,1)");
  EXPECT_EQ(tap_call(true, true), "MCALL CYCLE840(10,1,0,-8,,,3,4,1)");
}

TEST(CycleCall, IsMadeOnlyWhereTheCycleDoesTheSame) {
  const PrintGrid grid(false, 3);
  EXPECT_FALSE(has_cycle(hole(DrillForm::kChips, grid, 2), 0)) << "chips are broken at the feed there";
  EXPECT_FALSE(has_cycle(hole(DrillForm::kPecks, grid, 2), 1)) << "a dwell would come after every peck";
  EXPECT_TRUE(has_cycle(hole(DrillForm::kAtOnce, grid), 1));
}

}  // namespace
}  // namespace clearcut::post
