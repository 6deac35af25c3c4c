// Constants of the texts as numbers, so that a change of 1 % in one of them shows; scripts/mutants.sh makes such changes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "base/error.h"
#include "kinematics/kinematics.h"
#include "order/genetic/genetic.h"
#include "order/lattice.h"
#include "order/search/solve.h"
#include "pipeline/compare.h"
#include "pipeline/tool_sets.h"
#include "pipeline/tour/engagement_model.h"
#include "pipeline/tour/tour.h"
#include "pipeline/tour/tour_solver.h"
#include "plan/common/layers.h"
#include "plan/contour/contour.h"
#include "plan/grid/interpolate.h"
#include "plan/grid/shape.h"
#include "plan/grid/visit.h"
#include "plan/tour/tour.h"

namespace clearcut::pipeline {
namespace {

/// CPO-rho eq. 9: T = sum L / V_f + 2 (1 + nd) tau, tau = 0.177 s.
TEST(PublishedConstants, TimeOfEquation9) {
  EXPECT_NEAR(published_seconds(100, 0), 100.354, 1e-9);
  EXPECT_NEAR(published_seconds(100, 9), 103.54, 1e-9);
}

/// The same as an objective: a row of four points 1 mm apart at 60 mm/min has no turn.
TEST(PublishedConstants, TimeAsAnObjective) {
  order::Problem row = order::lattice_problem(4, 1);
  row.shape = order::Shape::kOpenPath;
  EXPECT_NEAR(order::solve(row, *order::time_objective(60), {}).objective, 3 + 0.354, 1e-9);
}

/// The same with a corner: three points around it, 2 mm, one turn.
TEST(PublishedConstants, TimeOfATurnAsAnObjective) {
  order::Problem corner = order::lattice_problem(2, 2);
  corner.points.pop_back();
  corner.shape = order::Shape::kOpenPath;
  EXPECT_NEAR(order::solve(corner, *order::time_objective(60), {}).objective, 2 + 0.708, 1e-9);
}

/// Its parts for proven bounds: a second for a mm at 60 mm/min, 2 tau for each turn and once.
TEST(PublishedConstants, TimeAsASumOfItsParts) {
  const auto linear = order::time_objective(60)->linear();
  EXPECT_NEAR(linear.length, 1, 1e-12);
  EXPECT_NEAR(linear.turns, 0.354, 1e-12);
  EXPECT_NEAR(linear.constant, 0.354, 1e-12);
}

/// Tour eq. 4.22 as restated in docs/tour.md.
TEST(PublishedConstants, CostOfEngagement) {
  EXPECT_NEAR(engagement_cost(-0.3), 0.3, 1e-12);
  EXPECT_NEAR(engagement_cost(0.2), std::exp(1.0) - 1, 1e-12);
  EXPECT_NEAR(inverse_engagement_cost(-0.04), 0.5, 1e-12);
}

/// Angles are of the leading half circle. The load of the one move between two points follows from its cost at a target of 100 %.
TEST(PublishedConstants, TargetOfEngagement) {
  EXPECT_EQ(engagement_target(std::nullopt), 0.5);
  EXPECT_NEAR(engagement_target(45), 0.25, 1e-12);
  order::Problem row = order::lattice_problem(2, 1);
  row.shape = order::Shape::kOpenPath;
  TourOptions options;
  options.objective = "engagement-exact";
  options.diameter = 0.5;
  options.engagement_percent = 100;
  const double load = 1 - solve_tour(row, options).solution.objective;
  EXPECT_GT(load, 0.8);
  options.engagement_percent = 60;
  EXPECT_NEAR(solve_tour(row, options).solution.objective, engagement_cost(load - 0.6), 1e-9);
}

/// The cutter of points without one is two pitches wide: their median, 2 mm, of 24 at 1 mm and 26 at 2 mm from the next.
TEST(PublishedConstants, CutterOfPointsIsTwoPitchesWide) {
  order::Problem pairs;
  for (int pair = 0; pair < 25; ++pair) {
    pairs.points.push_back({100.0 * pair, 0});
    pairs.points.push_back({100.0 * pair + (pair < 12 ? 1 : 2), 0});
  }
  pairs.shape = order::Shape::kOpenPath;
  TourOptions options;
  options.objective = "engagement";
  try {
    solve_tour(pairs, options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                ::testing::HasSubstr("4 mm is too small for points that reach over 2406 mm; engagement "
                                     "needs a cutter of at least 6.015 mm here"));
  }
}

/// Grbl's rule as docs/tour.md states it, by hand: at 1200 mm/min, 200 mm/s^2 and 0.01 mm a corner of 90 degrees is passed at
/// sqrt(200 * 0.01 * s / (1 - s)), s = sin 45, 2.1974 mm/s, and costs (20 - 2.1974)^2 / (200 * 20) s.
TEST(PublishedConstants, TimeOfAMachineInACorner) {
  order::Problem corner;
  corner.points = {{0, 0}, {50, 0}, {50, 50}, {0, 0}};
  corner.shape = order::Shape::kOpenPath;
  Machine machine;
  machine.acceleration = 200;
  machine.junction_deviation = 0.01;
  const auto time = machine_time_objective(machine, MmPerMin::of(1200));
  const order::Moves moves(corner);
  EXPECT_NEAR(time->edge(moves, 0, 1), 2.5, 1e-12);
  EXPECT_NEAR(time->corner(moves, 0, 1, 2), 0.07923, 1e-5);
  const double s = std::sin(kPi / 8), junction = std::sqrt(2 * s / (1 - s));  // back by 135 degrees
  EXPECT_NEAR(time->corner(moves, 1, 2, 3), (20 - junction) * (20 - junction) / 4000, 1e-12);
}

/// Tour eq. 4.21: pixel = accuracy sqrt(2) pi r.
TEST(PublishedConstants, PixelOfTheRaster) {
  EXPECT_NEAR(raster_pixel(5, 0.02), 0.444288, 1e-6);
}

/// CPO-rho eq. 8 with w = 1 mm, which its figure 11 prints as 0.7187.
TEST(PublishedConstants, OverlapOfOneMillimetre) {
  EXPECT_NEAR(plan::contour::rho(kPi / 3, 8), 0.71875, 1e-9);
}

/// CPO-rho section 4: n = 1000 V_c / (pi D), V_f = f_z Z n.
TEST(PublishedConstants, SpeedsOfACutter) {
  Tool tool;
  tool.diameter = 10;
  tool.teeth = 2;
  const CuttingData data = driven(tool, 36.6, 0.05);
  EXPECT_NEAR(data.spindle_rpm.value(), 1165.0142, 1e-3);
  EXPECT_NEAR(data.feed.value().mm_per_min(), 116.50142, 1e-4);
}

/// Tour 4.3.2: 25 individuals of which no two share more than a fifth of their edges, 24 neighbours.
TEST(PublishedConstants, PopulationOfTheAlgorithm) {
  const order::GeneticOptions published;
  EXPECT_EQ(published.population, 25);
  EXPECT_EQ(published.neighbours, 24);
  EXPECT_EQ(published.most_shared, 0.2);
}

/// Tour 4.3.3: "1000 generations without any improvement". A row of points begins at its optimum.
TEST(PublishedConstants, PatienceOfTheAlgorithm) {
  order::Problem row = order::lattice_problem(6, 1);
  row.shape = order::Shape::kOpenPath;
  const auto result = published_order(row, *order::length_objective(), {});
  EXPECT_EQ(result.value, 5);
  EXPECT_EQ(result.generations, 1000);
  EXPECT_EQ(result.children, 25000);
}

/// Grid section III: three points a square along a line, circles in steps of a micrometre.
TEST(PublishedConstants, Interpolators) {
  EXPECT_EQ(plan::grid::interpolate_line({0, 0}, {100, 0}, 1).size(), 300u);
  EXPECT_EQ(plan::grid::circle_step(5, 1), 0.001);
}

/// Beside x = -r a step dx changes y by sqrt(2 r dx), a third of a square at most; x runs from -r to r.
TEST(PublishedConstants, StepsOfTheCircle) {
  EXPECT_NEAR(plan::grid::circle_step(50, 0.3), 1e-4, 1e-12);
  EXPECT_EQ(plan::grid::circle_at_origin(1, 0.25).size(), 18u);
}

TEST(PublishedConstants, LongArcsEndWhereTheySay) {
  const Edge arc = Edge::arc({5, 0}, {0, -5}, {0, 0}, Turn::kCounterClockwise);
  const auto points = plan::grid::interpolate_arc(arc, 1);
  ASSERT_GT(points.size(), 2u);
  EXPECT_LT(distance(points[points.size() - 2], arc.to), 0.1);
}

DesignElement element_of(ElementKind kind, Vec2 from, Vec2 to) {
  DesignElement element;
  element.kind = kind;
  element.from = from;
  element.to = to;
  return element;
}

/// Grid section III: the cutter's centre stays a radius from both ends, so that a line is at least as long as the cutter is wide.
TEST(PublishedConstants, CurvesOfTheCentreEndARadiusBeforeTheirEnds) {
  EXPECT_FALSE(plan::grid::core_of(element_of(ElementKind::kLine, {0, 0}, {9.99, 0}), 5));
  EXPECT_TRUE(plan::grid::core_of(element_of(ElementKind::kLine, {0, 0}, {10.01, 0}), 5));
  DesignElement arc = element_of(ElementKind::kArc, {20, 0}, {-20, 0});
  arc.radius = 20;
  const auto core = plan::grid::core_of(arc, 5);
  ASSERT_TRUE(core);
  EXPECT_NEAR(distance(core->from, arc.from), 5, 1e-9);
  EXPECT_NEAR(distance(core->to, arc.to), 5, 1e-9);
}

/// An arc has a curve of the centre as long as its ends are more than two chords of a radius apart.
TEST(PublishedConstants, ShortArcsHaveNoCurveOfTheCentre) {
  const double chords = 4 * std::asin(5.0 / 40);
  for (const auto& [share, is_there] : {std::pair(0.995, false), std::pair(1.005, true)}) {
    const double sweep = share * chords;
    DesignElement arc = element_of(ElementKind::kArc, {20, 0}, Vec2{std::cos(sweep), std::sin(sweep)} * 20);
    arc.radius = 20;
    EXPECT_EQ(plan::grid::core_of(arc, 5).has_value(), is_there) << share;
  }
}

TEST(PublishedConstants, HolesAndSlotsAreAsWideAsTheySay) {
  DesignElement hole = element_of(ElementKind::kHole, {30, 30}, {30, 30});
  DesignElement slot = element_of(ElementKind::kSlot, {10, 0}, {40, 0});
  hole.width = slot.width = 14;
  EXPECT_NEAR(plan::grid::shape_of(hole, 3).area(), kPi * 49, 1e-9);
  EXPECT_NEAR(plan::grid::shape_of(slot, 3).area(), kPi * 49 + 30 * 14, 1e-9);
}

/// 81 whole points lie within 5 of one of them.
TEST(PublishedConstants, HolesAndSlotsActivateAllSquaresWithinHalfTheirWidth) {
  const SquareGrid grid{{0, 0}, 1, 100, 100};
  DesignElement hole = element_of(ElementKind::kHole, {30, 30}, {30, 30});
  DesignElement slot = element_of(ElementKind::kSlot, {10, 20}, {40, 20});
  hole.width = slot.width = 10;
  EXPECT_EQ(plan::grid::interpolate(hole, grid).size(), 81u);
  EXPECT_EQ(plan::grid::interpolate(slot, grid).size(), 81u + 30 * 11);
}

ElementJob job_of(const DesignElement& element, double diameter) {
  ElementJob job;
  job.stock = {Box{{0, 0}, {60, 60}}, -10, 0};
  Tool tool;
  tool.number = element.tool;
  tool.diameter = diameter;
  job.tools = {tool};
  job.elements = {element};
  job.elements.front().depth = 1;
  return job;
}

std::string faults_in(const ElementJob& job) {
  std::string texts;
  for (const auto& fault : plan::grid::faults_of(job)) texts += fault.text + "\n";
  return texts;
}

/// The centre reaches to a tool's radius from the wall, and visits the rim of where it may be.
TEST(PublishedConstants, TheCentreVisitsTheRimOfItsRoomInAHole) {
  DesignElement hole = element_of(ElementKind::kHole, {30, 30}, {30, 30});
  hole.width = 14;
  double farthest = 0;
  for (const auto& point : plan::grid::tabulate(job_of(hole, 6)).points) {
    if (point.reduced) farthest = std::max(farthest, distance(point.at, hole.from));
  }
  EXPECT_NEAR(farthest, 4, 1e-9);
}

/// A hole hardly wider than its tool has all squares; one as wide as the tool has its axis.
TEST(PublishedConstants, HolesAsWideAsTheToolAreTheirAxis) {
  DesignElement hole = element_of(ElementKind::kHole, {30, 30}, {30, 30});
  hole.width = 10.05;
  EXPECT_EQ(plan::grid::tabulate(job_of(hole, 10)).points.size(), 81u);
  hole.width = 10;
  EXPECT_EQ(plan::grid::tabulate(job_of(hole, 10)).points.size(), 1u);
}

TEST(PublishedConstants, ArcsReachOverTheirChord) {
  DesignElement arc = element_of(ElementKind::kArc, {10, 30}, {50, 30});
  arc.radius = 19.9;
  EXPECT_THAT(faults_in(job_of(arc, 6)), ::testing::HasSubstr("chord of 40 mm: at least 20 mm is needed"));
  arc.radius = 20;
  EXPECT_EQ(faults_in(job_of(arc, 6)), "");
}

TEST(PublishedConstants, ToolsAreSmallerThanHalfARectangle) {
  DesignElement pocket = element_of(ElementKind::kRectangle, {10, 10}, {10, 10});
  pocket.length = pocket.width = 20;
  EXPECT_EQ(faults_in(job_of(pocket, 19.9)), "");
  EXPECT_THAT(faults_in(job_of(pocket, 20)), ::testing::HasSubstr("too large for half the side of 20 mm"));
}

Layer square_layer(double side, double radius) {
  Layer layer;
  const std::vector<Vec2> corners{{0, 0}, {side, 0}, {side, side}, {0, side}};
  layer.target = layer.allowed = {Region::from_valid_loops(loop_from_points(corners), {})};
  layer.tool_radius = radius;
  return layer;
}

/// Tour eq. 4.8: spacing = diameter times engagement, from the corner of the legal area.
TEST(PublishedConstants, SpacingOfTheGrid) {
  plan::tour::TourGridOptions grid = plan::tour::parse_tour_grid("0.5");
  grid.published = true;
  plan::tour::plan_tour(square_layer(40, 5), grid,
                        [](const plan::tour::TourTask& task) {
                          EXPECT_EQ(task.points.size(), 49u);
                          EXPECT_NEAR(task.points.at(0).x, 5, 1e-9);
                          EXPECT_NEAR(task.points.at(1).x, 10, 1e-9);
                          std::vector<int> order(task.points.size());
                          std::iota(order.begin(), order.end(), 0);
                          return order;
                        },
                        {});
}

/// Tour eq. 4.9 and 4.10: a wall that leans by 30 degrees keeps steps of 0.2 mm with layers of 0.2 / sin 30, and stands z tan 30 farther in
/// at a depth of z.
TEST(PublishedConstants, LayersUnderAScallop) {
  Feature feature;
  feature.target = feature.allowed = square_layer(40, 5).target;
  feature.floor_z = -4;
  feature.wall_slope = Radians::of(kPi / 6);
  Operation operation;
  operation.stepdown = 3;
  operation.scallop = 0.2;
  const auto layers = plan::layers_of(feature, operation, 5, {});
  ASSERT_EQ(layers.size(), 10u);
  EXPECT_NEAR(layers.front().z, -0.4, 1e-9);
  const double side = 40 - 2 * 4 * std::tan(kPi / 6);
  EXPECT_NEAR(area(layers.back().target), side * side, 1e-3);
}

/// Tour eq. 4.6: P = sweep / (2 acos((r - e) / r)) + 1 points.
TEST(PublishedConstants, ChordsOfAnArc) {
  std::vector<Vec2> points;
  append_flattened(Edge::arc({10, 0}, {-10, 0}, {0, 0}, Turn::kCounterClockwise), 0.01, points);
  EXPECT_EQ(points.size(), std::ceil(kPi / (2 * std::acos(0.999))));
}

}  // namespace
}  // namespace clearcut::pipeline
