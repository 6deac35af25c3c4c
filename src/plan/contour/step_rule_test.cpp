// Steps by rule: the published ones as published, the corrected ones so that nothing is left.
#include "plan/contour/step_rule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/random.h"
#include "plan/contour/ring_band.h"

namespace clearcut::plan::contour {
namespace {

const Tolerances kTol;

Region polygon(const std::vector<Vec2>& points) {
  return Region::from_valid_loops(loop_from_points(points), {});
}

Rest rest_of(const Region& region, const StepRule& rule, double radius) {
  return worst_rest({region}, rule, radius, kTol);
}

/// Levels of the contours around the deepest place.
std::vector<double> levels_of(const Region& region, const std::string& rule, double radius) {
  std::vector<double> levels;
  for (const auto& node : ring_tree(
           Clearance(region, kTol), region, radius,
           [&](const RingNode&ring, const std::vector<AxisPiece>&inside) {
             return step_after(ring, inside, parse_step_rule(rule), radius);
           },
           kTol)) {
    levels.push_back(node.level);
  }
  return levels;
}

Region triangle(double edge) {
  return polygon({{0, 0}, {edge, 0}, {edge / 2, edge * std::sqrt(3) / 2}});
}

TEST(StepRule, KappaAndItsCorrectionAgreeInATriangle) {
  const auto published = levels_of(triangle(200), "lom", 5),
             corrected = levels_of(triangle(200), "lom-corrected", 5);
  ASSERT_GE(published.size(), 4u);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_NEAR(published[i] - published[i - 1], 10 * kappa(60 * kPi / 180), 1e-9);
    EXPECT_NEAR(corrected[i] - corrected[i - 1], 10 * kappa(60 * kPi / 180), 0.003);
  }
}

TEST(StepRule, RhoAndItsCorrectionAgreeInATriangle) {
  for (const char* w : {"", ":0.5", ":2"}) {
    const auto published = levels_of(triangle(200), std::string("rho") + w, 5);
    const auto corrected = levels_of(triangle(200), std::string("rho-corrected") + w, 5);
    EXPECT_NEAR(published[1] - published[0], corrected[1] - corrected[0], 0.003);
  }
}

/// CPO-rho eq. 8: w is the parameter that the paper prints as 1 mm.
TEST(StepRule, TheOverlapOfRhoIsAParameter) {
  const auto levels = levels_of(triangle(200), "rho:0.5", 5);
  EXPECT_NEAR(levels[1] - levels[0], 10 * rho(60 * kPi / 180, 5, 0.5), 1e-9);
}

/// Of a cutter narrower than 2 mm the overlap is half of its radius.
TEST(StepRule, TheOverlapOfRhoIsAtMostHalfTheRadius) {
  const auto levels = levels_of(triangle(40), "rho", 1);
  EXPECT_NEAR(levels[1] - levels[0], 2 * rho(60 * kPi / 180, 1, 0.5), 1e-9);
}

/// No contour is farther from the last than the diameter, whatever is stated.
TEST(StepRule, TheWidestStepIsTheDiameter) {
  for (const char* rule : {"widest", "10.2mm", "1"}) {
    const auto levels = levels_of(triangle(200), rule, 5);
    EXPECT_NEAR(levels[1] - levels[0], 10, 1e-9) << rule;
  }
}

/// Halfway along the bisector of a reflex corner is as far from both contours as in a convex one: R (1 + sin(alpha / 2)), less w in the
/// second term.
TEST(StepRule, CorrectedStepsPastReflexCorners) {
  RingNode ring;
  ring.contour =
      polygon({{0, 0}, {60, 0}, {60, 20}, {20, 20}, {20, 60}, {0, 60}});  // one corner of 270 degrees
  const double sine = std::sin(135 * kPi / 180);
  EXPECT_NEAR(step_past_reflex_corners(ring, parse_step_rule("lom-corrected"), 5), 5 + 5 * sine, 1e-9);
  EXPECT_NEAR(step_past_reflex_corners(ring, parse_step_rule("rho-corrected:2"), 5), 5 + 3 * sine, 1e-9);
  EXPECT_EQ(step_past_reflex_corners(ring, parse_step_rule("0.5,lom-corrected"), 5),
            std::numeric_limits<double>::infinity());
}

TEST(StepRule, ValuesPerContour) {
  const auto levels = levels_of(triangle(200), "0.5,3mm,lom", 5);
  ASSERT_GE(levels.size(), 5u);
  EXPECT_NEAR(levels[1] - levels[0], 5, 1e-9);
  EXPECT_NEAR(levels[2] - levels[1], 3, 1e-9);
  EXPECT_NEAR(levels[3] - levels[2], 7.5, 1e-9);
  EXPECT_NEAR(levels[4] - levels[3], 7.5, 1e-9);
}

/// CPO-kappa alg. 3: where the next contour would vanish and R < A < 2R, a reduced loop 3/2 R kappa farther in.
TEST(StepRule, AReducedLoopInTheCentre) {
  // Half widths of 13.55 and 13 mm and a step of 8.5355: A = 8.55 lets the plain step fit, A = 8 does not.
  const auto plain = levels_of(polygon({{0, 0}, {27.1, 0}, {27.1, 27.1}, {0, 27.1}}), "lom", 5);
  ASSERT_EQ(plain.size(), 2u);
  EXPECT_NEAR(plain[1] - plain[0], 10 * kappa(kPi / 2), 1e-9);
  const auto reduced = levels_of(polygon({{0, 0}, {26, 0}, {26, 26}, {0, 26}}), "lom", 5);
  ASSERT_EQ(reduced.size(), 2u);
  EXPECT_NEAR(reduced[1] - reduced[0], 7.5 * kappa(kPi / 2), 1e-9);
}

/// Contours of all pockets of a layer, those as far from the wall as each other as one.
TEST(StepRule, ContoursOfTwoPocketsAtOneDistanceAreOne) {
  const Regions pockets{polygon({{0, 0}, {30, 0}, {30, 30}, {0, 30}}),
                        polygon({{40, 0}, {70, 0}, {70, 30}, {40, 30}})};
  const auto steps = contour_steps(pockets, parse_step_rule("lom"), 5, 5, kTol);
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].from_wall, 5);
  EXPECT_NEAR(steps[1].from_wall, 5 + 10 * kappa(kPi / 2), 1e-9);
}

TEST(StepRule, LinesAreAFractionOfTheDiameterApart) {
  EXPECT_EQ(line_distance(Stepover{"0.4"}, 10), 4);
  EXPECT_EQ(line_distance(Stepover{"4.5mm"}, 10), 4.5);
  EXPECT_EQ(line_distance(Stepover{}, 10), std::nullopt);
}

TEST(StepRule, SaysWhatItTakes) {
  for (const char* bad :
       {"rho:", "rho:x", "rho:-1", "lom:1", "0.5,", ",0.5", "0.5,2", "widest:1", "second:inf"}) {
    EXPECT_THROW(parse_step_rule(bad), InputError) << bad;
  }
  EXPECT_EQ(parse_step_rule("rho-corrected:0.5").value, 0.5);
  EXPECT_EQ(parse_step_rule("lom-corrected").kind, StepRule::Kind::kKappaCorrected);
}

TEST(RingBand, AnEdgeThatVanishesLeavesASharperCorner) {
  // Two corners of 121 degrees merge into one of 62 once the edge of 8 mm between them has gone.
  const double lean = 31 * kPi / 180, flank = 120;
  const Vec2 a{0, 0}, b{8, 0};
  const Vec2 c = b + Vec2{std::sin(lean), std::cos(lean)} * flank,
             d = a + Vec2{-std::sin(lean), std::cos(lean)} * flank;
  const Rest rest = rest_of(polygon({a, b, c, d}), parse_step_rule("0.93"), 5);
  EXPECT_EQ(rest.cause, RestCause::kCorner);
}

TEST(RingBand, NamesCentresRidgesAndNecks) {
  EXPECT_EQ(rest_of(polygon({{0, 0}, {27, 0}, {27, 27}, {0, 27}}), parse_step_rule("0.87"), 5).cause,
            RestCause::kCentre);
  EXPECT_EQ(rest_of(polygon({{0, 0}, {90, 0}, {90, 27}, {0, 27}}), parse_step_rule("0.87"), 5).cause,
            RestCause::kRidge);
  const Region waist = polygon({{0, 0}, {40, 9.5}, {80, 0}, {80, 40}, {40, 30.5}, {0, 40}});
  EXPECT_EQ(rest_of(waist, parse_step_rule("0.75"), 5).cause, RestCause::kNeck);
  EXPECT_EQ(rest_of(polygon({{0, 0}, {90, 0}, {90, 27}, {0, 27}}), parse_step_rule("0.5"), 5).cause,
            RestCause::kNone);
}

/// A ring at the level of a ridge that leads to wider places has no width there: what lies about the ridge stays.
TEST(RingBand, ARingAtTheLevelOfARidgeClearsNothing) {
  const Region angle = polygon({{0, 0}, {60, 0}, {60, 20}, {30, 20}, {30, 40}, {0, 40}});
  EXPECT_NE(rest_of(angle, parse_step_rule("6mm"), 4).cause, RestCause::kNone);
  EXPECT_EQ(rest_of(angle, parse_step_rule("lom-corrected"), 4).cause, RestCause::kNone);
  EXPECT_LT(levels_of(angle, "lom-corrected", 4).at(1), 10 - 1e-3);
}

Region random_star(Random& random) {
  std::vector<Vec2> corners;
  const int n = 3 + static_cast<int>(random.below(9));
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * (i + random.between(0.1, 0.9)) / n, radius = random.between(25, 80);
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon(corners);
}

/// Whatever the shape: the corrected rules leave nothing, never step wider than the diameter nor less than the
/// radius, and the published ones do leave something now and then.
TEST(RingBand, CorrectedStepsLeaveNothing) {
  int published_fail = 0;
  for (int seed = 0; seed < 300; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Region region = random_star(random);
    const double radius = random.between(1, 5);
    for (const char* rule : {"lom-corrected", "rho-corrected"}) {
      const Rest rest = rest_of(region, parse_step_rule(rule), radius);
      EXPECT_EQ(rest.cause, RestCause::kNone) << seed << " " << rule << ": " << name_of(rest.cause) << " at "
                                              << rest.where.x << ", " << rest.where.y;
    }
    published_fail += rest_of(region, parse_step_rule("lom"), radius).cause != RestCause::kNone;
  }
  EXPECT_GT(published_fail, 10);
}

}  // namespace
}  // namespace clearcut::plan::contour
