// Forces against hand calculation.
#include <gtest/gtest.h>

#include <cmath>

#include "verify/engagement/load.h"

namespace clearcut::verify {
namespace {

TEST(Forces, FullSlotAgreesWithKienzleByHand) {
  const WorkMaterial steel = *work_material_named("steel");
  Tool tool;
  tool.diameter = 10;
  tool.teeth = 2;
  Move move{Edge::line({0, 0}, {20, 0}), -2, -2, MoveKind::kCut, MmPerMin::of(600), 1};
  CheckedMove checked;
  checked.move = &move;
  checked.tool = &tool;
  checked.rpm = 3000;
  const CutSample sample{{stock::AngleSet(-kPi / 2, kPi / 2), kPi, kPi / 2, kPi / 2}, 2, 20, {}};
  add_forces(checked, sample, steel);
  ASSERT_TRUE(checked.load.forces);
  const double chip = 0.1 * 10 / (5 * kPi), specific = 1990 * std::pow(chip, -0.26);
  EXPECT_NEAR(checked.load.forces->removed_mm3, 400, 1e-9);
  EXPECT_NEAR(checked.load.forces->energy_j, specific * 400 / 1000, 1e-9);
  EXPECT_NEAR(checked.load.forces->max_power_w, specific * 2 * 10 * 600 / 60000, 1e-9);
  EXPECT_NEAR(checked.load.forces->max_force_n, specific * 2 * 10 * 600 / 60000 * 60 / (kPi * 30), 1e-9);
  const double life = std::pow(500 / (kPi * 30), 4);
  EXPECT_NEAR(checked.load.forces->wear, 20.0 / 600 / 2 / life, 1e-12);
}

TEST(Forces, NeedASpindleSpeed) {
  Tool tool;
  tool.diameter = 10;
  Move move{Edge::line({0, 0}, {20, 0}), -2, -2, MoveKind::kCut, MmPerMin::of(600), 1};
  CheckedMove checked;
  checked.move = &move;
  checked.tool = &tool;
  const CutSample sample{{stock::AngleSet(0, 1), 1, 1, 0}, 2, 20, {}};
  add_forces(checked, sample, *work_material_named("brass"));
  EXPECT_FALSE(checked.load.forces);
}

}  // namespace
}  // namespace clearcut::verify
