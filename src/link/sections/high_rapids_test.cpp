#include "link/sections/high_rapids.h"

#include <gtest/gtest.h>

namespace clearcut::link {
namespace {

constexpr double kRadius = 3;

Tool mill() {
  Tool tool;
  tool.diameter = 2 * kRadius;
  return tool;
}

stock::Material block() {
  return stock::Material(Box{{-50, -50}, {50, 50}}, 0, {kRadius});
}

Move vertical(Vec2 at, double from, double to, MoveKind kind = MoveKind::kRapid) {
  return {Edge::line(at, at), from, to, kind, is_rapid(kind) ? MmPerMin() : MmPerMin::of(100), 0};
}

Move level(Vec2 from, Vec2 to, double z, MoveKind kind) {
  return {Edge::line(from, to), z, z, kind, is_rapid(kind) ? MmPerMin() : MmPerMin::of(500), 0};
}

/// As moves of a section joined end to start must be.
void expect_joined(const Section& section) {
  for (std::size_t i = 1; i < section.moves.size(); ++i) {
    EXPECT_EQ(section.moves[i].path.from, section.moves[i - 1].path.to) << i;
    EXPECT_EQ(section.moves[i].z_from, section.moves[i - 1].z_to) << i;
  }
}

std::vector<Move> kept_high(std::vector<Move> moves, stock::Material& material) {
  Section section;
  section.moves = std::move(moves);
  keep_rapids_high(section, mill(), {1, MmPerMin::of(100)}, material);
  expect_joined(section);
  return section.moves;
}

TEST(HighRapids, DownEndAboveWhatStandsAndTheRestIsFed) {
  auto material = block();
  material.add(level({0, 0}, {20, 0}, -4, MoveKind::kCut), kRadius);
  // 2 mm beside what was cut: a rim of it stands in the cutter's way.
  const auto moves =
      kept_high({vertical({0, 2}, 10, -3), vertical({0, 2}, -3, -6, MoveKind::kPlunge)}, material);
  ASSERT_EQ(moves.size(), 3u);
  EXPECT_EQ(moves[0].z_to, 1);
  EXPECT_EQ(moves[1].kind, MoveKind::kPlunge);
  EXPECT_EQ(moves[1].z_to, -3);
  EXPECT_EQ(moves[1].feed, MmPerMin::of(100));
  EXPECT_TRUE(material.is_removed({0, 4}, -6));
}

TEST(HighRapids, DownThroughWhatWasCutStay) {
  auto material = block();
  material.add(level({0, 0}, {20, 0}, -4, MoveKind::kCut), kRadius);
  const std::vector<Move> down{vertical({5, 0}, 10, -4)};
  const auto moves = kept_high(down, material);
  ASSERT_EQ(moves.size(), 1u);
  EXPECT_EQ(moves[0].z_to, -4);
  EXPECT_TRUE(is_rapid(moves[0].kind));
}

TEST(HighRapids, DownOverALedgeEndAboveTheLedge) {
  auto material = block();
  material.add(level({0, -10}, {0, 10}, -4, MoveKind::kCut), kRadius);
  material.add(level({4, -10}, {4, 10}, -2, MoveKind::kCut), kRadius);
  const auto moves = kept_high({vertical({2, 0}, 10, -4)}, material);
  ASSERT_EQ(moves.size(), 2u);
  EXPECT_EQ(moves[0].z_to, -1);
  EXPECT_EQ(moves[1].z_to, -4);
}

TEST(HighRapids, AcrossRiseOverWhatStandsInTheirWay) {
  auto material = block();
  material.add(level({0, 0}, {0.5, 0}, -4, MoveKind::kCut), kRadius);
  material.add(level({20, 0}, {20.5, 0}, -4, MoveKind::kCut), kRadius);
  const auto moves = kept_high(
      {level({0, 0}, {20, 0}, -3, MoveKind::kRapid), vertical({20, 0}, -3, -4, MoveKind::kPlunge)}, material);
  ASSERT_EQ(moves.size(), 4u);
  EXPECT_EQ(moves[1].z_to, 1);
  EXPECT_TRUE(is_rapid(moves[2].kind));
  EXPECT_EQ(moves[2].z_to, -3);
}

TEST(HighRapids, ConesRemoveTheirGroove) {
  auto material = block();
  Tool cone = mill();
  cone.kind = ToolKind::kVBit;
  cone.tip_angle = Radians::of_degrees(90);
  Section section;
  section.moves = {level({0, 0}, {20, 0}, -4, MoveKind::kCut)};
  keep_rapids_high(section, cone, {1, MmPerMin::of(100)}, material);
  EXPECT_TRUE(material.is_removed({10, 0.5}, -3.4));
  EXPECT_FALSE(material.is_removed({10, 0.5}, -3.6));
}

TEST(HighRapids, DownOverTheConeOfADrillEndAboveIt) {
  auto material = block();
  Tool drill = mill();
  drill.kind = ToolKind::kDrill;
  drill.tip_angle = Radians::of_degrees(90);
  Section section;
  section.moves = {vertical({5, 0}, 10, 1), vertical({5, 0}, 1, -6, MoveKind::kPlunge)};
  keep_rapids_high(section, drill, {1, MmPerMin::of(100)}, material);
  // Of its full width the hole is down to -6 + 3.
  const auto moves =
      kept_high({vertical({5, 0}, 10, -5), vertical({5, 0}, -5, -6, MoveKind::kPlunge)}, material);
  ASSERT_EQ(moves.size(), 3u);
  EXPECT_GT(moves[0].z_to, -3);
  EXPECT_LT(moves[0].z_to, 0);
  EXPECT_EQ(moves[1].kind, MoveKind::kPlunge);
}

}  // namespace
}  // namespace clearcut::link
