#include "link/lead.h"

#include <gtest/gtest.h>

#include "geometry/region.h"
#include "geometry/route/legal_area.h"

namespace clearcut::link {
namespace {

Region rectangle(double width, double height) {
  return Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{0, 0}, {width, 0}, {width, height}, {0, height}}), {});
}

void expect_legal(const Edge& edge, const Region& legal) {
  for (double t = 0; t <= 1; t += 0.05) {
    const Vec2 p = edge.at(t);
    EXPECT_TRUE(legal.contains(p) || legal.boundary_distance(p) < LegalArea::kSlack) << p.x << " " << p.y;
  }
}

/// Degrees between a lead and the pass where they meet.
double angle_between(Vec2 a, Vec2 b) {
  return std::abs(std::atan2(cross(a, b), dot(a, b))) * 180 / kPi;
}

TEST(Lead, ArcsTouchThePassAndStayLegal) {
  const Region legal = rectangle(30, 20);
  const auto lead = lead_for(legal.outer(), {legal}, {4, std::nullopt, 0});
  ASSERT_TRUE(lead);
  const Path path = begun_at(legal.outer(), lead->along);
  EXPECT_TRUE(lead->in.is_arc());
  EXPECT_NEAR(distance(lead->in.to, path.front().from), 0, 1e-12);
  EXPECT_NEAR(distance(lead->out.from, path.back().to), 0, 1e-12);
  EXPECT_NEAR(angle_between(lead->in.tangent_at(1), path.front().tangent_at(0)), 0, 1e-6);
  EXPECT_NEAR(angle_between(lead->out.tangent_at(0), path.back().tangent_at(1)), 0, 1e-6);
  expect_legal(lead->in, legal);
  expect_legal(lead->out, legal);
}

TEST(Lead, LinesMeetThePassAtTheAngleAskedFor) {
  const Region legal = rectangle(30, 20);
  for (const double degrees : {0.0, 10.0, 30.0, 60.0, 90.0}) {
    const auto lead = lead_for(legal.outer(), {legal}, {4, Radians::of_degrees(degrees), 0});
    ASSERT_TRUE(lead) << degrees;
    const Path path = begun_at(legal.outer(), lead->along);
    EXPECT_FALSE(lead->in.is_arc());
    EXPECT_NEAR(lead->in.length(), 4, 1e-9);
    EXPECT_NEAR(angle_between(lead->in.tangent_at(1), path.front().tangent_at(0)), degrees, 1e-6);
    EXPECT_NEAR(angle_between(lead->out.tangent_at(0), path.back().tangent_at(1)), degrees, 1e-6);
    expect_legal(lead->in, legal);
    expect_legal(lead->out, legal);
  }
}

TEST(Lead, WhereNoArcFitsALineDoes) {
  const Region legal = rectangle(30, 1.9);  // a quarter circle of 1 mm has no room, a line of 1 mm has
  const auto lead = lead_for(legal.outer(), {legal}, {4, std::nullopt, 0});
  ASSERT_TRUE(lead);
  EXPECT_FALSE(lead->in.is_arc());
  EXPECT_LE(lead->in.length(), 2 + 1e-9);
  expect_legal(lead->in, legal);
  expect_legal(lead->out, legal);
}

/// mm; how far a lead's beginning is off the line of the pass.
double off_pass(const Lead& lead, const Path& path) {
  const Edge pass = begun_at(path, lead.along).front();
  return std::abs(cross(pass.tangent_at(0), lead.in.from - pass.from));
}

/// The slot of a profile: earlier steps have left 0.3 mm beside the pass, and a little beyond that the slot ends.
TEST(Lead, BeginsWhereEarlierStepsHaveCutWhereItHasRoomFor) {
  const Region legal = rectangle(30, 0.55);
  for (const auto angle : {std::optional<Radians>(), std::optional<Radians>(Radians::of_degrees(60))}) {
    LeadShape shape{1, angle, 0};
    shape.room = 0.3;
    const auto lead = lead_for(legal.outer(), {legal}, shape);
    ASSERT_TRUE(lead);
    EXPECT_GE(off_pass(*lead, legal.outer()), 0.3 - 1e-9);
    expect_legal(lead->in, legal);
    expect_legal(lead->out, legal);
    shape.room = 0.6;  // more than there is: as small as it has to be
    EXPECT_TRUE(lead_for(legal.outer(), {legal}, shape));
  }
}

/// Beyond the slot material stands: beside an outer corner a lead of the same size begins farther from the pass than beside an edge.
TEST(Lead, BeginsNoFartherOutThanTheSlot) {
  const Region inside = rectangle(30, 20);
  Path around;  // counter-clockwise along the same edges, with the legal area outside
  for (auto edge = inside.outer().rbegin(); edge != inside.outer().rend(); ++edge)
    around.push_back(edge->reversed());
  const Loop far = loop_from_points(std::vector<Vec2>{{-20, -20}, {50, -20}, {50, 40}, {-20, 40}});
  const Region legal = Region::from_valid_loops(far, {around});
  LeadShape shape{0.3 * std::sqrt(2.0), Radians::of_degrees(45), 0};
  shape.room = 0.3;
  const auto to_pass = [&](const Lead& lead) {
    double least = HUGE_VAL;
    for (const Edge& edge : around) least = std::min(least, distance(edge, lead.in.from));
    return least;
  };
  const auto anywhere = lead_for(around, {legal}, shape);
  ASSERT_TRUE(anywhere);
  EXPECT_GT(to_pass(*anywhere), 0.31);
  shape.slot = 0.3;
  const auto in_slot = lead_for(around, {legal}, shape);
  ASSERT_TRUE(in_slot);
  EXPECT_NEAR(to_pass(*in_slot), 0.3, 1e-6);
}

TEST(Lead, NoneWhereNeitherFits) {
  const Region legal = rectangle(30, 0.1);
  EXPECT_FALSE(lead_for(legal.outer(), {legal}, {4, Radians::of_degrees(90), 0}));
}

TEST(Lead, ThePassRunsOverItsStartBeforeItIsLeft) {
  const Region legal = rectangle(30, 20);
  for (const double overlap : {0.5, 3.0, 17.0, 200.0}) {
    const auto lead = lead_for(legal.outer(), {legal}, {2, std::nullopt, overlap});
    ASSERT_TRUE(lead) << overlap;
    const Path path = overlapped(begun_at(legal.outer(), lead->along), overlap);
    EXPECT_NEAR(length(path), 100 + std::min(overlap, 100.0), 1e-9);
    EXPECT_NEAR(distance(path.back().to, lead->out.from), 0, 1e-9) << overlap;
    EXPECT_NEAR(distance(path.front().from, lead->in.to), 0, 1e-9) << overlap;
    expect_legal(lead->out, legal);
  }
}

}  // namespace
}  // namespace clearcut::link
