#include "link/entry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace clearcut::link {
namespace {

Regions square(double side) {
  return {Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{0, 0}, {side, 0}, {side, side}, {0, side}}), {})};
}

LinkOptions options_for(EntryKind entry) {
  LinkOptions options;
  options.tool_radius = 3;
  options.entry = entry;
  options.entry_angle = Radians::of_degrees(5);
  return options;
}

EntryPlace place_at(Vec2 start) {
  return {start, {1, 0}, 0.2, -4, std::nullopt, nullptr};
}

void expect_entry(const std::vector<Move>& moves, const EntryPlace& place, double steepest_deg,
                  const Regions& legal) {
  ASSERT_FALSE(moves.empty());
  if (!moves.front().path.is_arc()) {
    EXPECT_EQ(moves.front().path.from, place.start);
  }
  EXPECT_EQ(moves.front().z_from, place.z_above);
  EXPECT_EQ(moves.back().path.to, place.start);
  EXPECT_NEAR(moves.back().z_to, place.z, 1e-12);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (i > 0) {
      EXPECT_EQ(moves[i].path.from, moves[i - 1].path.to);
      EXPECT_NEAR(moves[i].z_from, moves[i - 1].z_to, 1e-12);
    }
    const double slope = (moves[i].z_from - moves[i].z_to) / length(Path{moves[i].path});
    EXPECT_LE(slope, std::tan(Radians::of_degrees(steepest_deg).radians()) + 1e-9);
    for (const double t : {0.0, 0.25, 0.5, 0.75}) {
      const Vec2 p = moves[i].path.at(t);
      EXPECT_TRUE(contains(legal, p) || legal[0].boundary_distance(p) < 1e-3);
    }
  }
}

TEST(Entry, HelixIsNoSteeperThanAskedForAndStaysLegal) {
  const auto legal = square(30);
  for (const double y : {0.0, 5.0, 15.0}) {
    const auto place = place_at({15, y});
    const auto moves = entry_at(place, legal, options_for(EntryKind::kHelix)).moves;
    expect_entry(moves, place, 5, legal);
    EXPECT_TRUE(moves.front().path.is_arc());
    EXPECT_EQ(moves.back().z_from, moves.back().z_to) << "ends with a flat circle";
  }
}

TEST(Entry, HelixTurnsNoFartherThanItsAngleAsksFor) {
  const auto moves = entry_at(place_at({15, 5}), square(30), options_for(EntryKind::kHelix)).moves;
  double path = 0;
  for (const Move& move : moves) path += move.z_from > move.z_to ? move.path.length() : 0;
  EXPECT_NEAR(path * std::tan(Radians::of_degrees(5).radians()), 4.2, 1e-9);
}

TEST(Entry, HelixShrinksUntilItFits) {
  const auto legal = square(2);
  const auto place = place_at({1, 0});
  const auto moves = entry_at(place, legal, options_for(EntryKind::kHelix)).moves;
  expect_entry(moves, place, 5, legal);
  EXPECT_LE(moves.front().path.radius(), 1.0);
}

TEST(Entry, PassesThatBeginOnACircleAreEnteredByAHelixWhateverIsAskedFor) {
  for (const EntryKind asked : {EntryKind::kPlunge, EntryKind::kRamp, EntryKind::kZigzagRamp}) {
    EntryPlace place = place_at({15, 5});
    place.circle_center = Vec2{13, 5};
    const Entry entry = entry_at(place, square(30), options_for(asked));
    EXPECT_EQ(entry.kind, EntryKind::kHelix);
    for (const Move& move : entry.moves) EXPECT_TRUE(move.path.is_arc());
  }
}

TEST(Entry, SlotTakesARampInsteadOfAHelix) {
  const Regions legal{Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{0, 0}, {30, 0}, {30, 0.2}, {0, 0.2}}), {})};
  const auto place = place_at({5, 0.1});
  const auto moves = entry_at(place, legal, options_for(EntryKind::kHelix)).moves;
  expect_entry(moves, place, 5, legal);
  EXPECT_FALSE(moves.front().path.is_arc());
}

TEST(Entry, PlungeGoesStraightDown) {
  const auto moves = entry_at(place_at({5, 5}), square(30), options_for(EntryKind::kPlunge)).moves;
  ASSERT_EQ(moves.size(), 1u);
  EXPECT_TRUE(moves[0].is_vertical());
  EXPECT_EQ(moves[0].kind, MoveKind::kPlunge);
}

/// A tangent leaves the area on the outer side of an arc, little by little: the way to and fro follows the arc.
TEST(Entry, ZigzagAlongAnArcStaysOnIt) {
  const Edge half = Edge::arc({20, 0}, {0, 20}, {0, 0}, Turn::kCounterClockwise);
  const Edge inner = Edge::arc({0, 19.9}, {19.9, 0}, {0, 0}, Turn::kClockwise);
  const Loop band{half, Edge::line(half.to, inner.from), inner, Edge::line(inner.to, half.from)};
  const Regions legal{Region::from_valid_loops(band, {})};
  const Path run{half};
  auto place = place_at({20, 0});
  place.direction = {0, 1};
  place.run = &run;
  for (const bool stays : {false, true}) {
    place.stays_on_run = stays;
    const auto entry = entry_at(place, legal, options_for(EntryKind::kZigzagRamp));
    EXPECT_EQ(entry.kind, EntryKind::kZigzagRamp);
    expect_entry(entry.moves, place, 5, legal);
    for (const Move& move : entry.moves) EXPECT_NEAR(norm(move.path.at(0.5)), 20, 1e-9);
  }
}

}  // namespace
}  // namespace clearcut::link
