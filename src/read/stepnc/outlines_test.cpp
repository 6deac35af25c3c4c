// Outlines of ISO 14649: profiles, curves, bosses.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "base/error.h"
#include "base/random.h"
#include "base/units.h"
#include "read/stepnc/shapes/placement.h"
#include "read/stepnc/test_program.h"

namespace clearcut::read::stepnc {
namespace {

using testing::all_diagnostics;
using testing::count_of;
using testing::expect_box;
using ::testing::HasSubstr;
using testing::Program;

TEST(StepNc, RectangularProfileHasItsLengthAlongX) {
  const Part part = Program().read();
  ASSERT_EQ(part.features.size(), 1U);
  const Feature& f = part.features[0];
  EXPECT_EQ(f.kind, FeatureKind::kClosedPocket);
  expect_box(f.target, 20, 80, 30, 50);
  expect_box(f.allowed, 20, 80, 30, 50);
  EXPECT_EQ(f.top_z, 0);
  EXPECT_EQ(f.floor_z, -5);
}

TEST(StepNc, PlacementsAreComposedFeatureThenProfile) {
  Program p;
  p.with(21, "AXIS2_PLACEMENT_3D('',#22,#40,#41)").with(22, "CARTESIAN_POINT('',(50.,10.,-1.))");
  p.with(40, "DIRECTION('',(0.,0.,1.))").with(41, "DIRECTION('',(0.,1.,0.))");
  p.with(29, "CARTESIAN_POINT('',(30.,5.,0.))").with(9, "WORKPIECE_SETUP(#3,$,$,$,())");
  const Feature f = p.read().features[0];
  expect_box(f.target, 35, 55, 10, 70);
  EXPECT_EQ(f.floor_z, -6) << "a depth is relative to its feature";
}

std::string entity_of(const char* keyword, Vec3 v) {
  return fmt::format("{}('',({:.12f},{:.12f},{:.12f}))", keyword, v.x, v.y, v.z);
}

/// A placement whose local Z is +Z or -Z, of any length, and whose reference direction leans out of the plane.
struct RandomPlacement {
  Vec3 origin;
  double turn = 0;
  double up = 1;

  explicit RandomPlacement(Random& random)
      : origin{random.between(-20, 20), random.between(-20, 20), random.between(-1, 1)},
        turn(random.between(-kPi, kPi)) {}

  /// As #id, with its parts after it.
  void write(Program& program, int id, Random& random) const {
    const double size = random.between(0.2, 5), lean = random.between(-0.9, 0.9);
    program.with(id, fmt::format("AXIS2_PLACEMENT_3D('',#{},#{},#{})", id + 1, id + 2, id + 3));
    program.with(id + 1, entity_of("CARTESIAN_POINT", origin));
    program.with(id + 2, entity_of("DIRECTION", {0, 0, up * size}));
    program.with(id + 3, entity_of("DIRECTION", {size * std::cos(turn), size * std::sin(turn), lean}));
  }
  /// X turned by `turn`, Y on its left, or on its right where Z points down.
  Vec2 point(Vec2 p) const {
    const double y = up * p.y;
    return {origin.x + p.x * std::cos(turn) - y * std::sin(turn),
            origin.y + p.x * std::sin(turn) + y * std::cos(turn)};
  }
};

TEST(StepNc, RandomPlacementsPutOutlinesWhereTheirAxesSay) {
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    const RandomPlacement feature(random), setup(random), depth(random);
    RandomPlacement profile(random);
    if (i % 3 == 0) profile.up = -1;
    const double width = random.between(2, 30), height = random.between(2, 30);
    Program p;
    p.with(5, "BLOCK('B',#6,400.,400.,40.)").with(60, "CARTESIAN_POINT('',(-200.,-200.,-35.))");
    p.with(62, fmt::format("TOLERANCED_LENGTH_MEASURE({:.12f},$)", height));
    p.with(63, fmt::format("TOLERANCED_LENGTH_MEASURE({:.12f},$)", width));
    p.with(9, "WORKPIECE_SETUP(#3,#300,$,$,())").with(24, "AXIS2_PLACEMENT_3D('',#401,#402,#403)");
    p.feature("CLOSED_POCKET('POCKET',#3,(#30),#500,#23,(),$,#26,$,$,#27)");
    feature.write(p, 500, random);
    profile.write(p, 200, random);
    setup.write(p, 300, random);
    depth.write(p, 400, random);
    p.with(401, entity_of("CARTESIAN_POINT", {depth.origin.x, depth.origin.y, -5}));
    p.with(27, "RECTANGULAR_CLOSED_PROFILE(#200,#62,#63)");
    SCOPED_TRACE(p.text());
    const Feature read = p.read().features.at(0);
    EXPECT_NEAR(read.floor_z, feature.origin.z - 5, 1e-6);
    EXPECT_NEAR(area(read.target), width * height, 1e-4);
    for (const Vec2 corner : {Vec2{1, 1}, Vec2{-1, 1}, Vec2{-1, -1}, Vec2{1, -1}}) {
      const Vec2 expected = feature.point(profile.point({corner.x * width / 2, corner.y * height / 2}));
      EXPECT_LT(read.target.at(0).boundary_distance(expected), 1e-6);
    }
  }
}

TEST(StepNc, NgonBySidesOrCorners) {
  Program p;
  p.with(27, "NGON_CLOSED_PROFILE(#28,#62,4,.T.)");
  expect_box(p.read().features[0].target, 40, 60, 30, 50);
  p.with(27, "NGON_CLOSED_PROFILE(#28,#62,4,.F.)");
  const double half = 10 / std::sqrt(2.0);
  expect_box(p.read().features[0].target, 50 - half, 50 + half, 40 - half, 40 + half);
}

TEST(StepNc, CompositeOutlineOfPolylinesAndTrimmedCircles) {
  // A 40 x 20 rectangle whose right end is a half circle; the second arc is written against the outline.
  Program p;
  p.with(27, "GENERAL_CLOSED_PROFILE($,#100)").with(100, "COMPOSITE_CURVE('',(#101,#102),.F.)");
  p.with(101, "COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#103)")
      .with(102, "COMPOSITE_CURVE_SEGMENT($,.F.,#104)");
  p.with(103, "POLYLINE('',(#105,#106,#107,#108))");
  p.with(105, "CARTESIAN_POINT('',(60.,50.,-9.))").with(106, "CARTESIAN_POINT('',(20.,50.,7.))");
  p.with(107, "CARTESIAN_POINT('',(20.,30.))").with(108, "CARTESIAN_POINT('',(60.,30.,0.,0.,0.))");
  p.with(104, "TRIMMED_CURVE('',#109,(#105),(#108),.F.,.CARTESIAN.)").with(109, "CIRCLE('',#110,10.)");
  p.with(110, "AXIS2_PLACEMENT_3D('',#111,$,$)").with(111, "CARTESIAN_POINT('',(60.,40.,0.))");
  const Part part = p.read();
  expect_box(part.features[0].target, 20, 70, 30, 50);
  EXPECT_NEAR(area(part.features[0].target), 800 + kPi * 50, 1e-9);
}

double area_of(const std::string& curve) {
  const Part part = Program()
                        .with(27, "GENERAL_CLOSED_PROFILE(#28,#70)")
                        .with(70, curve)
                        .with(71, "CARTESIAN_POINT('',(-30.,-15.,0.))")
                        .with(72, "CARTESIAN_POINT('',(-30.,25.,0.))")
                        .with(73, "CARTESIAN_POINT('',(30.,25.,0.))")
                        .with(74, "CARTESIAN_POINT('',(30.,-15.,0.))")
                        .with(80, "COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#82)")
                        .with(81, "COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#83)")
                        .with(82,
                              "B_SPLINE_CURVE_WITH_KNOTS('',3,(#71,#72,#73,#74),.UNSPECIFIED.,.F.,.F.,(4,4),"
                              "(0.,1.),.UNSPECIFIED.)")
                        .with(83, "POLYLINE('',(#74,#71))")
                        .with(84, "COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#85)")
                        .with(85, "BEZIER_CURVE('',3,(#71,#72,#73,#74),.UNSPECIFIED.,.F.,.F.)")
                        .read();
  return area(part.features.at(0).target);
}

/// A pocket over a triangle whose first side is a line trimmed by points, from (20, 10) to (40, 10).
Program trimmed_by_points(const std::string& point, const std::string& direction, const std::string& sense) {
  Program p;
  p.with(27, "GENERAL_CLOSED_PROFILE($,#70)").with(70, "COMPOSITE_CURVE('',(#71,#72),.F.)");
  p.with(71, "COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#73)");
  p.with(72, "COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#74)");
  p.with(73, "TRIMMED_CURVE('',#75,(#80),(#81)," + sense + ",.CARTESIAN.)");
  p.with(74, "POLYLINE('',(#81,#82,#80))").with(75, "LINE('',#76,#77)");
  p.with(76, "CARTESIAN_POINT('',(" + point + ",0.))").with(77, "VECTOR('',#78,3.)");
  p.with(78, "DIRECTION('',(" + direction + ",0.))").with(80, "CARTESIAN_POINT('',(20.,10.,0.))");
  p.with(81, "CARTESIAN_POINT('',(40.,10.,0.))").with(82, "CARTESIAN_POINT('',(30.,40.,0.))");
  return p;
}

TEST(StepNc, LinesTrimmedByPointsThatLieOnThemAreFollowed) {
  const std::string wrong = "as its trim points do";
  for (const auto& [point, direction, sense] :
       {std::tuple{"20.,10.", "1.,0.", ".T."}, {"-7.,10.", "-1.,0.", ".F."}, {"20.,10.", "1.,0.", "$"}}) {
    const std::string said = all_diagnostics(trimmed_by_points(point, direction, sense).read());
    for (const char* entity : {"LINE", "TRIMMED_CURVE", "VECTOR", "the line"})
      EXPECT_THAT(said, ::testing::Not(HasSubstr(std::string("not followed: ") + entity))) << point;
  }
  for (const auto& [point, direction, sense] :
       {std::tuple{"20.,11.", "1.,0.", ".T."}, {"20.,10.", "1.,0.1", ".T."}, {"20.,10.", "1.,0.", ".F."}})
    EXPECT_THAT(all_diagnostics(trimmed_by_points(point, direction, sense).read()), HasSubstr(wrong))
        << point << " " << direction << " " << sense;
}

TEST(StepNc, EllipsesAndSplinesBecomeLinesAndArcs) {
  EXPECT_NEAR(area_of("ELLIPSE('',#21,20.,10.)"), 200 * kPi, 0.2);
  // A cubic over a base of 60 with its handles 40 high: 0.6 of base times handles.
  EXPECT_NEAR(area_of("COMPOSITE_CURVE('',(#80,#81),.F.)"), 1440, 0.2);
  EXPECT_NEAR(area_of("COMPOSITE_CURVE('',(#84,#81),.F.)"), 1440, 0.2);
}

TEST(StepNc, SplinesThatDoNotFitTogetherAreRefusedByName) {
  const auto error = [](const std::string& curve) {
    return Program()
        .with(27, "GENERAL_CLOSED_PROFILE(#28,#70)")
        .with(70, curve)
        .with(71, "CARTESIAN_POINT('',(-30.,-15.,0.))")
        .error();
  };
  EXPECT_THAT(error("B_SPLINE_CURVE_WITH_KNOTS('',3,(#71,#71),.U.,.F.,.F.,(4,4),(0.,1.),.U.)"),
              HasSubstr("#70 B_SPLINE_CURVE_WITH_KNOTS: a spline with 8 knots for 2 control points"));
  EXPECT_THAT(error("B_SPLINE_CURVE_WITH_KNOTS('',3,(#71,#71),.U.,.F.,.F.,(4),(0.,1.),.U.)"),
              HasSubstr("differ in number"));
  EXPECT_THAT(error("B_SPLINE_CURVE_WITH_KNOTS('',3,(#71,#71),.U.,.F.,.F.,(99999,4),(0.,1.),.U.)"),
              HasSubstr("multiplicity"));
  EXPECT_THAT(error("BEZIER_CURVE('',0,(#71,#71),.U.,.F.,.F.)"), HasSubstr("degree 0"));
  EXPECT_THAT(error("BEZIER_CURVE('',3,(),.U.,.F.,.F.)"), HasSubstr("0 control points"));
  EXPECT_THAT(error("ELLIPSE('',#21,20.,0.)"), HasSubstr("semi-axis"));
}

TEST(StepNc, TrimPointsOffTheirCircleKeepTheRadius) {
  Program p;  // a 20 x 20 square with one corner of radius 5, its trim points 4 um off
  p.with(27, "GENERAL_CLOSED_PROFILE($,#100)").with(100, "COMPOSITE_CURVE('',(#101,#102),.F.)");
  p.with(101, "COMPOSITE_CURVE_SEGMENT($,.T.,#103)").with(102, "COMPOSITE_CURVE_SEGMENT($,$,#104)");
  p.with(103, "POLYLINE('',(#105,#106,#107,#108,#109))");
  p.with(105, "CARTESIAN_POINT('',(35.,50.,0.))").with(106, "CARTESIAN_POINT('',(20.,50.,0.))");
  p.with(107, "CARTESIAN_POINT('',(20.,30.,0.))").with(108, "CARTESIAN_POINT('',(40.,30.,0.))");
  p.with(109, "CARTESIAN_POINT('',(40.,45.,0.))");
  p.with(104, "TRIMMED_CURVE('',#110,(#109),(#105),$,$)").with(110, "CIRCLE('',#111,5.)");
  p.with(111, "AXIS2_PLACEMENT_3D('',#112,$,$)").with(112, "CARTESIAN_POINT('',(34.996,45.,0.))");
  const Part part = p.read();
  const Loop& loop = part.features[0].target[0].outer();
  ASSERT_EQ(loop.size(), 5U);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    EXPECT_EQ(loop[i].to, loop[(i + 1) % loop.size()].from) << "joined exactly";
    if (loop[i].is_arc()) {
      EXPECT_NEAR(loop[i].radius(), 5, 1e-12);
    }
  }
}

TEST(StepNc, GapsUpToTheToleranceAreClosedAndReported) {
  Program p;
  p.with(27, "GENERAL_CLOSED_PROFILE($,#100)").with(100, "COMPOSITE_CURVE('',(#101,#102),.F.)");
  p.with(101, "COMPOSITE_CURVE_SEGMENT($,.T.,#103)").with(102, "COMPOSITE_CURVE_SEGMENT($,.T.,#104)");
  p.with(103, "POLYLINE('',(#105,#106,#107))").with(104, "POLYLINE('',(#108,#109,#105))");
  p.with(105, "CARTESIAN_POINT('',(20.,20.,0.))").with(106, "CARTESIAN_POINT('',(40.,20.,0.))");
  p.with(107, "CARTESIAN_POINT('',(40.,40.,0.))").with(108, "CARTESIAN_POINT('',(40.,40.008,0.))");
  p.with(109, "CARTESIAN_POINT('',(20.,40.,0.))");
  const Part part = p.read();
  EXPECT_EQ(count_of(part, Severity::kRepair), 1) << all_diagnostics(part);
  EXPECT_THAT(all_diagnostics(part), HasSubstr("closed a gap of 0.008 mm at (40, 40)"));
  p.with(108, "CARTESIAN_POINT('',(40.,40.02,0.))");
  EXPECT_THAT(p.error(), HasSubstr("POLYLINE: the outline has a gap of 0.02 mm at (40, 40); close it"));
}

TEST(StepNc, BossesBecomeIslandsPlacedInTheFeature) {
  Program p;
  p.feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(#70,#71),$,#26,$,$,#27)");
  p.with(70, "BOSS('B1',#3,(),#72,#23,#73,$)").with(72, "AXIS2_PLACEMENT_3D('',#74,$,$)");
  p.with(74, "CARTESIAN_POINT('',(35.,40.,0.))").with(73, "CIRCULAR_CLOSED_PROFILE($,#75)");
  p.with(75, "TOLERANCED_LENGTH_MEASURE(8.,$)");
  p.with(71, "BOSS('B2',#3,(),#76,#23,#73,$)").with(76, "AXIS2_PLACEMENT_3D('',#77,$,$)");
  p.with(77, "CARTESIAN_POINT('',(65.,40.,0.))");
  Feature f = p.read().features[0];
  ASSERT_EQ(f.target.size(), 1U);
  EXPECT_EQ(f.target[0].islands().size(), 2U);
  EXPECT_NEAR(area(f.target), 1200 - 2 * kPi * 16, 1e-9);
  // A boss that reaches into the wall bites a piece out of the pocket instead.
  p.with(77, "CARTESIAN_POINT('',(80.,40.,0.))");
  f = p.read().features[0];
  ASSERT_EQ(f.target.size(), 1U);
  EXPECT_EQ(f.target[0].islands().size(), 1U);
  EXPECT_NEAR(area(f.target), 1200 - 1.5 * kPi * 16, 1e-3);
}

}  // namespace
}  // namespace clearcut::read::stepnc
