// The printed tables of CPO-kappa and CPO-rho.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "plan/common/layers.h"
#include "plan/contour/contour.h"

namespace clearcut::plan::contour {
namespace {

double radians(double degrees) {
  return Radians::of_degrees(degrees).radians();
}

/// Printed figures are cut to three digits, not rounded.
double cut(double value) {
  return std::floor(value * 1000 + 1e-9) / 1000;
}

constexpr double kAngles[] = {10, 30, 50, 70, 90, 110, 130, 150, 170};

TEST(Formulas, CpoRhoTable2Lom) {
  const double printed[] = {.543, .629, .711, .786, .853, .909, .953, .982, .998};
  for (int i = 0; i < 9; ++i) EXPECT_DOUBLE_EQ(cut(kappa(radians(kAngles[i]))), printed[i]) << kAngles[i];
}

struct PrintedRow {
  double radius;
  double printed[9];
};

constexpr PrintedRow kTable2[] = {{5, {.534, .603, .669, .729, .782, .827, .862, .886, .898}},
                                  {10, {.539, .616, .690, .758, .818, .868, .907, .934, .948}},
                                  {20, {.541, .622, .700, .772, .835, .889, .930, .958, .973}},
                                  {30, {.542, .625, .704, .777, .841, .895, .938, .966, .981}},
                                  {40, {.542, .626, .706, .779, .844, .899, .941, .970, .985}},
                                  {50, {.542, .626, .707, .781, .846, .901, .944, .973, .988}}};
constexpr PrintedRow kTable1[] = {{5, {.09, .26, .42, .57, .71, .82, .91, .96, 1.00}},
                                  {10, {.08, .26, .42, .56, .70, .82, .92, .96, 1.00}},
                                  {20, {.08, .28, .44, .56, .72, .80, .92, .96, 1.00}},
                                  {30, {.06, .24, .42, .54, .72, .84, .90, .96, 1.02}},
                                  {40, {.08, .24, .40, .56, .72, .80, .96, .96, 1.04}},
                                  {50, {.10, .30, .40, .50, .70, .80, .90, .90, 1.00}}};

/// Cells of table 2 that a coefficient of (alpha, radius) gives to the printed digit.
template <typename Coefficient>
int cells_of_table_2(Coefficient coefficient) {
  int same = 0;
  for (const PrintedRow& row : kTable2)
    for (int i = 0; i < 9; ++i) same += cut(coefficient(radians(kAngles[i]), row.radius)) == row.printed[i];
  return same;
}

TEST(Formulas, CpoRhoTable2Rho) {
  EXPECT_EQ(cells_of_table_2([](double alpha, double radius) { return rho(alpha, radius); }), 54);
}

/// What the table would show if a constant of the rule were another: it holds w to 1 % in the small radii, and the rest
/// nearly everywhere.
TEST(Formulas, CpoRhoTable2ShowsAChangeOfOnePerCent) {
  EXPECT_LT(cells_of_table_2([](double alpha, double radius) { return rho(alpha, radius, 1.01); }), 54);
  EXPECT_LT(cells_of_table_2([](double alpha, double radius) { return rho(alpha, radius, 0.99); }), 54);
  EXPECT_LT(cells_of_table_2([](double alpha, double radius) { return rho(alpha, 1.01 * radius); }), 54);
  EXPECT_LT(cells_of_table_2([](double alpha, double radius) { return rho(1.01 * alpha, radius); }), 10);
  EXPECT_EQ(cells_of_table_2([](double alpha, double radius) { return 1.01 * rho(alpha, radius); }), 0);
}

/// The printed overlaps come from coefficients that were cut to three digits.
TEST(Formulas, CpoRhoTable1) {
  for (const PrintedRow& row : kTable1) {
    for (int i = 0; i < 9; ++i) {
      const double alpha = radians(kAngles[i]);
      EXPECT_NEAR(2 * row.radius * (cut(kappa(alpha)) - cut(rho(alpha, row.radius))), row.printed[i], 1e-9)
          << row.radius << " " << kAngles[i];
    }
  }
}

/// Captions: CPO-kappa figure 9 (tips of 90 degrees), CPO-rho figure 10 (30 degrees, R = 4).
TEST(Formulas, CoefficientsOfTheCaptions) {
  EXPECT_DOUBLE_EQ(std::floor(kappa(radians(90)) * 1e4) / 1e4, 0.8535);
  EXPECT_DOUBLE_EQ(std::floor(rho(radians(30), 4) * 1e4) / 1e4, 0.5970);
}

TEST(Formulas, ResidualVanishesAtKappa) {
  for (const double degrees : kAngles) {
    EXPECT_NEAR(residual_size(radians(degrees), 8, 1 - kappa(radians(degrees))), 0, 1e-12);
    EXPECT_GT(residual_size(radians(degrees), 8, 0.99 - kappa(radians(degrees))), 0);
  }
}

/// Eq. 4 as a number: R = 5, alpha = 60 degrees, step 7.01, so overlap 0.299.
TEST(Formulas, ResidualOfFigure10) {
  EXPECT_NEAR(residual_size(radians(60), 5, 0.299), -0.98, 1e-9);
}

TEST(Formulas, PassageOfTheTriangle) {
  EXPECT_NEAR(passage_length(7.01, radians(60)), 14.02, 1e-12);
}

TEST(Formulas, RhoOfTheTriangleWithRadius8) {
  EXPECT_DOUBLE_EQ(std::floor(rho(radians(60), 8) * 1e4) / 1e4, 0.7187);
}

TEST(StepRule, ReadsWhatTheCommandLineAccepts) {
  EXPECT_EQ(parse_step_rule("lom").kind, StepRule::Kind::kKappa);
  EXPECT_EQ(parse_step_rule("rho").kind, StepRule::Kind::kRho);
  EXPECT_EQ(parse_step_rule("3.5mm").value, 3.5);
  EXPECT_EQ(parse_step_rule("3.5mm").kind, StepRule::Kind::kMm);
  EXPECT_EQ(parse_step_rule("0.4").kind, StepRule::Kind::kFraction);
  EXPECT_EQ(parse_step_rule("40%").kind, StepRule::Kind::kFraction);
  EXPECT_DOUBLE_EQ(parse_step_rule("40%").value, 0.4);
  for (const char* bad : {"", "0", "1.01", "-3mm", "mm", "%", "0%", "101%", "40%mm", "nan"})
    EXPECT_THROW(parse_step_rule(bad), InputError) << bad;
}

/// An isosceles triangle: one angle of 20 degrees at the origin, two of 80.
Region wedge() {
  const double half = radians(10);
  const Vec2 corners[] = {{0, 0}, direction_of(-half) * 100, direction_of(half) * 100};
  return Region::from_valid_loops(loop_from_points(corners), {});
}

TEST(SecondAngle, LeavesASingleSmallestOneToThePassages) {
  EXPECT_NEAR(second_smallest_angle(wedge()), radians(80), 1e-9);
  EXPECT_EQ(single_smallest_corner(wedge()), (Vec2{0, 0}));
  const Vec2 square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_FALSE(single_smallest_corner(Region::from_valid_loops(loop_from_points(square), {})));
}

TEST(SecondAngle, PassagesRunAlongTheBisectorFromContourToContour) {
  Layer layer;
  layer.z = -1;
  layer.tool_radius = 2;
  layer.allowed = layer.target = {wedge()};
  ContourOptions options;
  options.step = parse_step_rule("second");
  options.residuals = ResidualRule::kPassages;
  const double step = 2 * layer.tool_radius * rho(radians(80), layer.tool_radius);
  int rings = 0, passages = 0;
  for (const Pass& pass : plan_contour(layer, options, {}).passes) {
    if (pass.closed) {
      ++rings;
      continue;
    }
    ++passages;
    ASSERT_EQ(pass.path.size(), 1u);
    EXPECT_NEAR(length(pass.path), passage_length(step, radians(20)), 1e-6);
    EXPECT_NEAR(pass.path[0].from.y, 0, 1e-6);
    EXPECT_NEAR(pass.path[0].to.y, 0, 1e-6);
  }
  EXPECT_GE(rings, 3);
  EXPECT_EQ(passages, rings - 1);
}

TEST(LayerHeights, StepsDownAndEndsOnTheFloor) {
  EXPECT_EQ(layer_heights(0, -2, 5), std::vector<double>({-2}));
  EXPECT_EQ(layer_heights(0, -12, 5), std::vector<double>({-5, -10, -12}));
  EXPECT_EQ(layer_heights(-12, -17, 2.5), std::vector<double>({-14.5, -17}));
  EXPECT_TRUE(layer_heights(0, 0, 1).empty());
  EXPECT_TRUE(layer_heights(0, 1, 1).empty());
}

TEST(LayerHeights, ASliverIsSharedOut) {
  const auto heights = layer_heights(0, -10.1, 5);
  ASSERT_EQ(heights.size(), 3u);
  EXPECT_NEAR(heights[0], -10.1 / 3, 1e-12);
  EXPECT_NEAR(heights[1], -20.2 / 3, 1e-12);
  EXPECT_EQ(heights[2], -10.1);
}

TEST(LayerHeights, RoundingMakesNoLayer) {
  EXPECT_EQ(layer_heights(0.3, 0, 0.1).size(), 3u);
  EXPECT_EQ(layer_heights(10.1, 0.1, 1).size(), 10u);
}

TEST(LayerHeights, RefusesStepsThatCannotBeMeant) {
  EXPECT_THROW(layer_heights(0, -1, 0), InputError);
  EXPECT_THROW(layer_heights(0, -1, -1), InputError);
  EXPECT_THROW(layer_heights(0, -10, 1e-4), InputError);
}

}  // namespace
}  // namespace clearcut::plan::contour
