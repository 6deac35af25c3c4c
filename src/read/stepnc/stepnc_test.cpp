// What each entity of ISO 14649 comes to. Files of real writers are read in tests/read/stepnc_test.cpp.
#include "read/stepnc/stepnc.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "base/error.h"
#include "base/units.h"

namespace clearcut::read::stepnc {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// A program on a block x 0..100, y 0..80, z -20..0 with one workingstep (#10) on the feature #20, 5 mm deep,
/// by a 10 mm end mill. Entities given by number replace or add to these.
class Program {
 public:
  Program& with(int id, const std::string& entity) {
    entities_[id] = entity;
    return *this;
  }
  Program& feature(const std::string& entity) { return with(20, entity); }

  std::string text() const {
    std::string out = "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('" + schema_ + "'));\nENDSEC;\nDATA;\n";
    for (const auto& [id, entity] : entities_) out += "#" + std::to_string(id) + "=" + entity + ";\n";
    return out + "ENDSEC;\nEND-ISO-10303-21;\n";
  }
  Program& schema(const std::string& name) {
    schema_ = name;
    return *this;
  }
  Part read() const { return read_stepnc(text(), "t.p21", {}); }
  std::string error() const {
    try {
      read();
    } catch (const InputError& e) {
      return e.what();
    }
    return "no error";
  }

 private:
  std::string schema_ = "MACHINING_SCHEMA";
  std::map<int, std::string> entities_ = {
      {1, "PROJECT('P',#2,(#3),$,$,$)"},
      {2, "WORKPLAN('MAIN',(#10),$,#4,$)"},
      {3, "WORKPIECE('WP',$,$,$,$,#5,())"},
      {4, "SETUP('S',$,#7,(#9))"},
      {5, "BLOCK('B',#6,100.,80.,20.)"},
      {6, "AXIS2_PLACEMENT_3D('',#60,$,$)"},
      {60, "CARTESIAN_POINT('',(0.,0.,-20.))"},
      {7, "PLANE('SECURITY',#8)"},
      {8, "AXIS2_PLACEMENT_3D('',#61,$,$)"},
      {61, "CARTESIAN_POINT('',(0.,0.,30.))"},
      {9, "WORKPIECE_SETUP(#3,#21,$,$,())"},
      {10, "MACHINING_WORKINGSTEP('WS1',#7,#20,#30,$)"},
      {20, "CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),$,#26,$,$,#27)"},
      {21, "AXIS2_PLACEMENT_3D('',#22,$,$)"},
      {22, "CARTESIAN_POINT('',(0.,0.,0.))"},
      {23, "PLANE('DEPTH',#24)"},
      {24, "AXIS2_PLACEMENT_3D('',#25,$,$)"},
      {25, "CARTESIAN_POINT('',(0.,0.,-5.))"},
      {26, "PLANAR_POCKET_BOTTOM_CONDITION()"},
      {27, "RECTANGULAR_CLOSED_PROFILE(#28,#62,#63)"},
      {28, "AXIS2_PLACEMENT_3D('',#29,$,$)"},
      {29, "CARTESIAN_POINT('',(50.,40.,0.))"},
      {62, "TOLERANCED_LENGTH_MEASURE(20.,$)"},
      {63, "TOLERANCED_LENGTH_MEASURE(60.,$)"},
      {30, "BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',8.,$,#31,#34,#35,$,#36,$,#37,2.,4.,0.3,0.1)"},
      {31, "MILLING_CUTTING_TOOL('T5',#32,(),$,$,$)"},
      {32, "ENDMILL(#33,3,.RIGHT.,$,$)"},
      {33, "MILLING_TOOL_DIMENSION(10.,$,$,25.,0.5,$,$)"},
      {34, "MILLING_TECHNOLOGY(0.01,.TCP.,$,-100.,$,$,$,$,$)"},
      {35, "MILLING_MACHINE_FUNCTIONS(.T.,$,$,.F.,$,(),.F.,$,$,())"},
      {36, "PLUNGE_RAMP($,0.05)"},
      {37, "CONTOUR_PARALLEL(0.5,.T.,.CCW.,.CONVENTIONAL.)"}};
};

std::string all_diagnostics(const Part& part) {
  std::string all;
  for (const Diagnostic& d : part.diagnostics.items()) all += d.where + ": " + d.what + "\n";
  return all;
}

int count_of(const Part& part, Severity severity) {
  int count = 0;
  for (const Diagnostic& d : part.diagnostics.items()) count += d.severity == severity;
  return count;
}

void expect_box(const Regions& regions, double x0, double x1, double y0, double y1) {
  const Box b = box(regions);
  EXPECT_NEAR(b.min.x, x0, 1e-6);
  EXPECT_NEAR(b.max.x, x1, 1e-6);
  EXPECT_NEAR(b.min.y, y0, 1e-6);
  EXPECT_NEAR(b.max.y, y1, 1e-6);
}

TEST(StepNc, ReadsTheDirectionOfStrokesAndNamesWhatElseIsLeftToThePlanner) {
  const Part part = Program()
                        .with(37, "BIDIRECTIONAL_MILLING(0.5,.T.,#38,.LEFT.,.LOOP_BACK.)")
                        .with(38, "DIRECTION('',(0.,2.,0.))")
                        .read();
  EXPECT_EQ(part.workplan[0].operation.feed_direction, Radians::of(kPi / 2));
  std::string said;
  for (const auto& item : part.diagnostics.items()) said += item.what + "\n";
  EXPECT_NE(said.find("the stroke connection is not used"), std::string::npos) << said;
  EXPECT_NE(said.find("the stepover direction is not used"), std::string::npos) << said;
}

TEST(StepNc, ReadsProjectStockToolsAndOperation) {
  const Part part = Program().read();
  EXPECT_EQ(part.name, "P");
  EXPECT_EQ(part.source_file, "t.p21");
  ASSERT_TRUE(part.stock);
  EXPECT_EQ(part.stock->plan.max, (Vec2{100, 80}));
  EXPECT_EQ(part.stock->z_bottom, -20);
  EXPECT_EQ(part.stock->z_top, 0);
  EXPECT_EQ(part.clearance_z, 30);
  ASSERT_EQ(part.tools.size(), 1U);
  EXPECT_EQ(part.tools[0].number, 5);
  EXPECT_EQ(part.tools[0].name, "T5");
  EXPECT_EQ(part.tools[0].diameter, 10);
  EXPECT_EQ(part.tools[0].corner_radius, 0.5);
  EXPECT_EQ(part.tools[0].teeth, 3);
  EXPECT_EQ(part.tools[0].flute_length, 25);
  ASSERT_EQ(part.workplan.size(), 1U);
  const Operation& op = part.workplan[0].operation;
  EXPECT_EQ(part.workplan[0].name, "WS1");
  EXPECT_EQ(op.name, "OP");
  EXPECT_EQ(op.kind, OperationKind::kRoughing);
  EXPECT_EQ(op.cutting.feed, MmPerMin::of(600)) << "0.01 m/s";
  EXPECT_EQ(op.cutting.spindle_rpm, 6000) << "100 1/s";
  EXPECT_TRUE(op.cutting.spindle_clockwise);
  EXPECT_TRUE(op.cutting.coolant);
  EXPECT_EQ(op.stepdown, 2);
  EXPECT_EQ(op.stepover, 0.4) << "radial depth 4 of 10 mm goes before the strategy's overlap";
  EXPECT_EQ(op.allowance_side, 0.3);
  EXPECT_EQ(op.allowance_floor, 0.1);
  EXPECT_EQ(op.entry, EntryKind::kRamp);
  EXPECT_EQ(op.entry_angle, Radians::of(0.05));
  EXPECT_EQ(op.direction, CutDirection::kConventional);
  EXPECT_EQ(op.strategy_hint, "contour_parallel");
  EXPECT_EQ(op.retract_z, 8);
}

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

TEST(StepNc, WhatIsNotUsedIsSaid) {
  const std::string radius = "CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),$,#26,$,#62,#27)";
  EXPECT_THAT(all_diagnostics(Program().feature(radius).read()),
              HasSubstr("corners stay as the profile draws"));
  EXPECT_THAT(all_diagnostics(Program().feature(radius).with(27, "CIRCULAR_CLOSED_PROFILE(#28,#62)").read()),
              Not(HasSubstr("corners stay")));
  EXPECT_THAT(
      all_diagnostics(
          Program().with(90, "(CONVERSION_BASED_UNIT('INCH',#91)LENGTH_UNIT()NAMED_UNIT(#92))").read()),
      HasSubstr("lengths of ISO 14649 programs are mm"));
  EXPECT_THAT(Program().with(2, "WORKPLAN('MAIN',(#11),$,#4,$)").with(11, "PARALLEL('P',(#10),$)").error(),
              HasSubstr("#11 PARALLEL is no machining workingstep"));
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

TEST(StepNc, EveryApproachAndRetractStrategyIsReadOrNamed) {
  struct Row {
    const char* approach;
    std::optional<EntryKind> entry;
    std::optional<double> angle, size, lead, lead_angle;
    int notes;
  };
  const std::nullopt_t none = std::nullopt;
  const Row rows[] = {{"PLUNGE_TOOLAXIS($)", EntryKind::kPlunge, none, none, none, none, 0},
                      {"PLUNGE_RAMP($,0.05)", EntryKind::kRamp, 0.05, none, none, none, 0},
                      {"PLUNGE_HELIX($,3.,0.05)", EntryKind::kHelix, 0.05, 3.0, none, none, 0},
                      {"PLUNGE_ZIGZAG($,0.05,8.)", EntryKind::kZigzagRamp, 0.05, 8.0, none, none, 0},
                      {"AP_RETRACT_TANGENT($,2.5)", none, none, none, 2.5, none, 0},
                      {"AP_RETRACT_ANGLE($,0.5,4.)", none, none, none, 4.0, 0.5, 0},
                      {"AP_LIFT_PATH_ANGLE($,0.1,2.)", EntryKind::kRamp, 0.1, none, none, none, 0},
                      {"AP_LIFT_PATH_TANGENT($,2.,1.)", EntryKind::kRamp, none, none, none, none, 1},
                      {"ALONG_PATH($,#99)", none, none, none, none, none, 1}};
  const int other_notes = count_of(Program().read(), Severity::kNote);
  const auto value = [](const std::optional<Radians>& angle) {
    return angle ? std::optional(angle->radians()) : std::nullopt;
  };
  for (const Row& row : rows) {
    const Part part = Program().with(36, row.approach).read();
    const Operation& op = part.workplan[0].operation;
    EXPECT_EQ(op.entry, row.entry) << row.approach;
    EXPECT_EQ(value(op.entry_angle), row.angle) << row.approach;
    EXPECT_EQ(op.entry_size, row.size) << row.approach;
    EXPECT_EQ(op.lead, row.lead) << row.approach;
    EXPECT_EQ(value(op.lead_angle), row.lead_angle) << row.approach;
    EXPECT_EQ(count_of(part, Severity::kNote), other_notes + row.notes) << all_diagnostics(part);
  }
}

TEST(StepNc, RetractStrategiesThatLeaveTheWallGiveLeads) {
  const auto with_retract = [](const std::string& retract) {
    Program p;
    p.with(30, "BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',8.,$,#31,#34,#35,$,#36,#99,#37,2.,4.,0.3,0.1)");
    return p.with(99, retract).read();
  };
  const Part arc = with_retract("AP_RETRACT_TANGENT($,2.5)");
  EXPECT_EQ(arc.workplan[0].operation.lead, 2.5);
  EXPECT_EQ(arc.workplan[0].operation.entry, EntryKind::kRamp);
  const Part line = with_retract("AP_RETRACT_ANGLE($,0.5,4.)");
  EXPECT_EQ(line.workplan[0].operation.lead, 4.0);
  EXPECT_EQ(line.workplan[0].operation.lead_angle, Radians::of(0.5));
  EXPECT_FALSE(with_retract("PLUNGE_TOOLAXIS($)").workplan[0].operation.lead);
  EXPECT_NE(all_diagnostics(with_retract("AP_LIFT_PATH_ANGLE($,0.5,4.)")).find("lifted straight up"),
            std::string::npos);
}

TEST(StepNc, SlopeIsTheAngleFromTheVertical) {
  Program p;
  p.feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),0.785,#26,$,$,#27)");
  EXPECT_EQ(p.read().features[0].wall_slope, Radians::of(0.785));
  p.feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),30.,#26,$,$,#27)");
  EXPECT_NEAR(p.read().features[0].wall_slope.degrees(), 30, 1e-12) << "above 2 pi: degrees";
  p.feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),5.,#26,$,$,#27)");
  EXPECT_NEAR(p.read().features[0].wall_slope.degrees(), 5, 1e-12) << "a wall cannot lean by 5 radians";
  p.feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),1.,#26,$,$,#27)").with(36, "PLUNGE_RAMP($,45.)");
  EXPECT_NEAR(p.read().features[0].wall_slope.degrees(), 1, 1e-12) << "another angle shows the file's unit";
}

TEST(StepNc, FaceWithoutBoundaryIsTheWholeStockAndOpenAllRound) {
  Program p;
  p.feature("PLANAR_FACE('FACE',#3,(#30),#21,#23,$,$,$,(#70))");
  p.with(70, "BOSS('B1',#3,(),#72,#23,#73,$)").with(72, "AXIS2_PLACEMENT_3D('',#74,$,$)");
  p.with(74, "CARTESIAN_POINT('',(35.,40.,0.))").with(73, "CIRCULAR_CLOSED_PROFILE($,#75)");
  p.with(75, "TOLERANCED_LENGTH_MEASURE(8.,$)");
  const Feature f = p.read().features[0];
  expect_box(f.target, 0, 100, 0, 80);
  expect_box(f.allowed, -kOpenReach, 100 + kOpenReach, -kOpenReach, 80 + kOpenReach);
  EXPECT_EQ(f.target[0].islands().size(), 1U);
  EXPECT_FALSE(contains(f.allowed, {35, 40}));
}

TEST(StepNc, FaceByCourseOfTravelAndRemovalBoundary) {
  Program p;
  p.feature("PLANAR_FACE('FACE',#3,(#30),#21,#23,#70,#71,$,())").with(70, "LINEAR_PATH($,#72,#73)");
  p.with(71, "LINEAR_PROFILE($,#74)").with(72, "TOLERANCED_LENGTH_MEASURE(80.,$)");
  p.with(73, "DIRECTION('',(0.,1.,0.))").with(74, "NUMERIC_PARAMETER('L',40.,'MM')");
  const Feature f = p.read().features[0];
  expect_box(f.target, 0, 40, 0, 80);
  EXPECT_TRUE(contains(f.allowed, {-50, 40})) << "open to the left";
  EXPECT_TRUE(contains(f.allowed, {20, 100})) << "open behind";
  EXPECT_FALSE(contains(f.allowed, {45, 40})) << "a wall at x 40";
  EXPECT_TRUE(contains(f.allowed, {150, 40})) << "beyond the stock is air";
}

TEST(StepNc, FaceInsideTheStockHasWallsAllRound) {
  Program p;
  p.feature("PLANAR_FACE('FACE',#3,(#30),#21,#23,$,$,#27,())");
  const Part part = p.read();
  expect_box(part.features[0].allowed, 20, 80, 30, 50);
  EXPECT_THAT(all_diagnostics(part), HasSubstr("does not reach the edge of the stock"));
}

TEST(StepNc, OpenPocketIsClosedRoundTheStock) {
  // Walls from the lower edge up, across, and down again: 30 x 25 mm, open below; the material is on their
  // left.
  Program p;
  p.feature("OPEN_POCKET('OPEN',#3,(#30),#21,#23,(),$,#26,$,$,#70,$)").with(70, "GENERAL_PROFILE($,#71)");
  p.with(71, "POLYLINE('',(#72,#73,#74,#75))");
  p.with(72, "CARTESIAN_POINT('',(30.,0.,0.))").with(73, "CARTESIAN_POINT('',(30.,25.,0.))");
  p.with(74, "CARTESIAN_POINT('',(60.,25.,0.))").with(75, "CARTESIAN_POINT('',(60.,0.,0.))");
  const Feature f = p.read().features[0];
  EXPECT_EQ(f.kind, FeatureKind::kOpenPocket);
  expect_box(f.target, 30, 60, 0, 25);
  EXPECT_NEAR(area(f.target), 750, 1e-3);
  EXPECT_TRUE(contains(f.allowed, {45, -20}));
  EXPECT_TRUE(contains(f.allowed, {-20, 40}));
  EXPECT_FALSE(contains(f.allowed, {20, 10}));
}

TEST(StepNc, OpenPocketAcrossACorner) {
  Program p;
  p.feature("OPEN_POCKET('OPEN',#3,(#30),#21,#23,(),$,#26,$,$,#70,$)").with(70, "GENERAL_PROFILE($,#71)");
  p.with(71, "POLYLINE('',(#72,#73,#74))");
  p.with(72, "CARTESIAN_POINT('',(70.,0.,0.))").with(73, "CARTESIAN_POINT('',(70.,50.,0.))");
  p.with(74, "CARTESIAN_POINT('',(100.,50.,0.))");
  const Feature f = p.read().features[0];
  expect_box(f.target, 70, 100, 0, 50);
  EXPECT_NEAR(area(f.target), 1500, 1e-3);
}

TEST(StepNc, OpenSidesThatMissTheEdgeByTheToleranceReachIt) {
  Program p;
  p.feature("OPEN_POCKET('OPEN',#3,(#30),#21,#23,(),$,#26,$,$,#70,$)").with(70, "GENERAL_PROFILE($,#71)");
  p.with(71, "POLYLINE('',(#72,#73,#74,#75))");
  p.with(72, "CARTESIAN_POINT('',(30.,0.006,0.))").with(73, "CARTESIAN_POINT('',(30.,25.,0.))");
  p.with(74, "CARTESIAN_POINT('',(60.,25.,0.))").with(75, "CARTESIAN_POINT('',(60.,0.,0.))");
  const Feature f = p.read().features[0];
  EXPECT_NEAR(area(f.target), 750, 1e-3);
  EXPECT_EQ(f.allowed.size(), 1U);
}

Program slot(const std::string& profile, const std::string& ends) {
  Program p;
  p.feature("SLOT('SLOT',#3,(#30),#21,#23,#70,#71," + ends + ")").with(22, "CARTESIAN_POINT('',(0.,40.,0.))");
  p.with(70, "LINEAR_PATH($,#72,#73)").with(71, profile).with(72, "TOLERANCED_LENGTH_MEASURE(100.,$)");
  p.with(73, "DIRECTION('',(1.,0.,0.))").with(74, "TOLERANCED_LENGTH_MEASURE(12.,$)");
  p.with(75, "OPEN_SLOT_END_TYPE()")
      .with(76, "RADIUSED_SLOT_END_TYPE()")
      .with(77, "WOODRUFF_SLOT_END_TYPE(#74)");
  return p.with(9, "WORKPIECE_SETUP(#3,$,$,$,())");
}

TEST(StepNc, SlotOpenAtBothEnds) {
  const Feature f = slot("SQUARE_U_PROFILE($,#74,$,$,$,$)", "(#75,#75)").read().features[0];
  EXPECT_EQ(f.kind, FeatureKind::kSlot);
  expect_box(f.target, 0, 100, 34, 46);
  EXPECT_TRUE(contains(f.allowed, {-30, 40}));
  EXPECT_TRUE(contains(f.allowed, {130, 40}));
  EXPECT_FALSE(contains(f.allowed, {50, 30}));
}

TEST(StepNc, SlotWithARoundEndInsideTheStock) {
  Program p = slot("SQUARE_U_PROFILE($,#74,$,$,$,$)", "(#75,#76)");
  const Feature f = p.with(72, "TOLERANCED_LENGTH_MEASURE(60.,$)").read().features[0];
  expect_box(f.target, 0, 66, 34, 46);
  EXPECT_NEAR(area(f.target), 720 + kPi * 18, 1e-3);
}

TEST(StepNc, SlotsWithWallsAtBothEndsNeedNoStock) {
  Program program;
  program.with(3, "WORKPIECE('WP',$,$,$,$,$,())")
      .feature("SLOT('SLOT',#3,(#30),#21,#23,#40,#41,(#42,#42))")
      .with(40, "LINEAR_PATH(#28,#63,#43)")
      .with(41, "SQUARE_U_PROFILE($,#62,$,$,$,$)")
      .with(42, "RADIUSED_SLOT_END_TYPE()")
      .with(43, "DIRECTION('',(1.,0.,0.))");
  const Part part = program.read();
  expect_box(part.features[0].target, 40, 120, 30, 50);
  EXPECT_NEAR(area(part.features[0].allowed), area(part.features[0].target), 1e-12);
  EXPECT_THAT(program.with(42, "OPEN_SLOT_END_TYPE()").error(), HasSubstr("give the WORKPIECE a BLOCK"));
}

TEST(StepNc, SlotAlongAnArc) {
  Program p = slot("SQUARE_U_PROFILE($,#74,$,$,$,$)", "(#76,#76)");
  p.with(70, "PARTIAL_CIRCULAR_PATH(#78,#79,1.5707963267948966)")
      .with(79, "TOLERANCED_LENGTH_MEASURE(20.,$)");
  p.with(78, "AXIS2_PLACEMENT_3D('',#80,$,$)").with(80, "CARTESIAN_POINT('',(40.,-10.,0.))");
  const Feature f = p.read().features[0];
  EXPECT_NEAR(area(f.target), kPi / 4 * (26 * 26 - 14 * 14) + kPi * 36, 1e-3);
}

TEST(StepNc, RoundedSlotIsCutWhereItsSidesAreUpright) {
  const Part part =
      slot("ROUNDED_U_PROFILE($,#74)", "(#75,#75)").with(25, "CARTESIAN_POINT('',(0.,0.,-9.))").read();
  EXPECT_EQ(part.features[0].floor_z, -3) << "6 mm of the 9 are the half round";
  EXPECT_EQ(count_of(part, Severity::kSkipped), 1);
}

TEST(StepNc, SlotsWithoutAFlatFloorAreRefusedByName) {
  EXPECT_THAT(slot("VEE_PROFILE($,#74,1.,0.5)", "(#75,#75)").error(),
              HasSubstr("VEE_PROFILE: a slot of this cross-section"));
  EXPECT_THAT(slot("TEE_PROFILE($,0.,0.,#74,#74,$,#74,$,$)", "(#75,#75)").error(), HasSubstr("TEE_PROFILE"));
  EXPECT_THAT(slot("SQUARE_U_PROFILE($,#74,$,$,$,$)", "(#75,#77)").error(),
              HasSubstr("WOODRUFF_SLOT_END_TYPE: a slot with this kind of end"));
}

Program step(double x, const std::string& direction) {
  Program p;
  p.feature("STEP('STEP',#3,(#30),#21,#23,#70,$,())")
      .with(22, "CARTESIAN_POINT('',(" + std::to_string(x) + ",0.,0.))");
  p.with(70, "LINEAR_PATH($,#72,#73)").with(72, "TOLERANCED_LENGTH_MEASURE(80.,$)");
  return p.with(73, "DIRECTION('',(" + direction + "))").with(9, "WORKPIECE_SETUP(#3,$,$,$,())");
}

TEST(StepNc, StepTakesTheSideAwayFromTheMaterial) {
  const Part part = step(85, "0.,1.,0.").read();
  expect_box(part.features[0].target, 85, 100, 0, 80);
  EXPECT_EQ(count_of(part, Severity::kWarning), 0);
  EXPECT_FALSE(contains(part.features[0].allowed, {84, 40}));
  EXPECT_TRUE(contains(part.features[0].allowed, {120, 40}));
}

TEST(StepNc, StepDrawnTheOtherWayRoundTakesTheSmallerSideAndSaysSo) {
  const Part part = step(15, "0.,1.,0.").read();
  expect_box(part.features[0].target, 0, 15, 0, 80);
  EXPECT_THAT(all_diagnostics(part), HasSubstr("the other side is taken"));
}

TEST(StepNc, RoundHoleBlindAndThrough) {
  Program p;
  p.feature("ROUND_HOLE('HOLE',#3,(#30),#28,#23,#62,$,#70)").with(70, "THROUGH_BOTTOM_CONDITION()");
  p.with(25, "CARTESIAN_POINT('',(0.,0.,-21.))")
      .with(30, "DRILLING($,$,'DRILL',$,$,#31,#34,#35,$,$,$,$,$,$)");
  p.with(32, "TWIST_DRILL(#33,2,$,$,$)");
  const Part part = p.read();
  EXPECT_EQ(part.features[0].kind, FeatureKind::kRoundHole);
  EXPECT_TRUE(part.features[0].through);
  EXPECT_EQ(part.features[0].hole_diameter, 20);
  EXPECT_EQ(part.features[0].floor_z, -21) << "a through hole may end below the stock";
  EXPECT_EQ(part.workplan[0].operation.kind, OperationKind::kDrilling);
  EXPECT_NEAR(area(part.features[0].target), 100 * kPi, 1e-9);
}

/// A blind 6 mm hole (#40) at (30, 40, 0), drilled; feature #20 is what the case says.
Program with_hole() {
  return Program()
      .with(40, "ROUND_HOLE('HOLE',#3,(),#41,#23,#43,$,#44)")
      .with(41, "AXIS2_PLACEMENT_3D('',#42,$,$)")
      .with(42, "CARTESIAN_POINT('',(30.,40.,0.))")
      .with(43, "TOLERANCED_LENGTH_MEASURE(6.,$)")
      .with(44, "FLAT_HOLE_BOTTOM()")
      .with(30, "DRILLING($,$,'DRILL',8.,$,#31,#34,#35,$,$,$,$,$,$)")
      .with(32, "TWIST_DRILL(#33,2,$,$,$)")
      .with(33, "MILLING_TOOL_DIMENSION(6.,$,$,25.,$,$,$)")
      .with(50, "AXIS2_PLACEMENT_3D('',#51,$,$)")
      .with(51, "CARTESIAN_POINT('',(50.,40.,0.))");
}

std::vector<Vec2> centres(const Part& part) {
  std::vector<Vec2> result;
  for (const Feature& feature : part.features) result.push_back(box(feature.target).center());
  return result;
}

void expect_centres(const Part& part, const std::vector<Vec2>& expected) {
  const std::vector<Vec2> got = centres(part);
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_LT(distance(got[i], expected[i]), 1e-9) << i;
}

TEST(StepNcPattern, CircularInDegrees) {
  const Part part = with_hole().feature("CIRCULAR_PATTERN('RING',#3,(),#50,#40,90.,4,(),(),$,0.)").read();
  expect_centres(part, {{30, 40}, {50, 20}, {70, 40}, {50, 60}});
  ASSERT_EQ(part.workplan.size(), 4U);
  EXPECT_EQ(part.features[3].name, "HOLE (4)");
  EXPECT_EQ(part.features[3].hole_diameter, 6);
  EXPECT_EQ(part.features[3].floor_z, -5);
  EXPECT_EQ(part.workplan[3].operation.kind, OperationKind::kDrilling);
  EXPECT_EQ(part.workplan[3].operation.retract_z, 8);
}

TEST(StepNcPattern, CircularInRadians) {
  expect_centres(
      with_hole().feature("CIRCULAR_PATTERN('',#3,(),#50,#40,1.5707963267948966,3,$,$,$,$)").read(),
      {{30, 40}, {50, 20}, {70, 40}});
}

/// Four members by 3 would be more than once round in radians.
TEST(StepNcPattern, SmallAnglesAreDegreesWhereRadiansWouldGoRoundTwice) {
  const Part part = with_hole().feature("CIRCULAR_PATTERN('',#3,(),#50,#40,3.,4,(),(),$,0.)").read();
  EXPECT_NEAR(centres(part)[1].y, 40 - 20 * std::sin(kPi / 60), 1e-9);
}

TEST(StepNcPattern, CircularWithMissingAndRelocatedMembers) {
  const Part part = with_hole()
                        .feature("CIRCULAR_PATTERN('RING',#3,(),#50,#40,90.,4,(#52),(#53),40.,0.)")
                        .with(52, "CIRCULAR_OFFSET(-90.,4)")
                        .with(53, "CIRCULAR_OMIT(3)")
                        .read();
  expect_centres(part, {{30, 40}, {50, 20}, {70, 40}});
  EXPECT_THAT(with_hole()
                  .feature("CIRCULAR_PATTERN('RING',#3,(),#50,#40,90.,4,(),(#53),40.,0.)")
                  .with(53, "CIRCULAR_OMIT(5)")
                  .error(),
              HasSubstr("#53 CIRCULAR_OMIT: its index is outside the pattern"));
}

TEST(StepNcPattern, PlacesCountFromZeroWhereOneIsZero) {
  const Part part = with_hole()
                        .feature("CIRCULAR_PATTERN('RING',#3,(),#50,#40,90.,4,(),(#52,#53),40.,0.)")
                        .with(52, "CIRCULAR_OMIT(0)")
                        .with(53, "CIRCULAR_OMIT(3)")
                        .read();
  expect_centres(part, {{50, 20}, {70, 40}});
  EXPECT_THAT(all_diagnostics(part), HasSubstr("counted from 0"));
}

/// Writers that place the base in the pattern's frame, or at its centre.
TEST(StepNcPattern, CircularBaseInOtherPlaces) {
  const std::string ring = "CIRCULAR_PATTERN('RING',#3,(),#50,#40,180.,2,(),(),40.,0.)";
  const Part inside = with_hole().with(42, "CARTESIAN_POINT('',(20.,0.,0.))").feature(ring).read();
  expect_centres(inside, {{70, 40}, {30, 40}});
  EXPECT_THAT(all_diagnostics(inside), HasSubstr("only when it is placed in the pattern"));
  const Part middle = with_hole().with(42, "CARTESIAN_POINT('',(50.,40.,0.))").feature(ring).read();
  expect_centres(middle, {{70, 40}, {30, 40}});
  EXPECT_THAT(all_diagnostics(middle), HasSubstr("placed at its centre"));
  EXPECT_THAT(with_hole()
                  .with(42, "CARTESIAN_POINT('',(50.,40.,0.))")
                  .feature("CIRCULAR_PATTERN('RING',#3,(),#50,#40,180.,2,(),(),$,0.)")
                  .error(),
              HasSubstr("lies on its axis"));
}

TEST(StepNcPattern, PocketsTurnByTheRotationOfTheBase) {
  Program program;
  program.with(40, "CLOSED_POCKET('P',#3,(),#41,#23,(),$,#26,$,$,#45)")
      .with(41, "AXIS2_PLACEMENT_3D('',#42,$,$)")
      .with(42, "CARTESIAN_POINT('',(20.,40.,0.))")
      .with(45, "RECTANGULAR_CLOSED_PROFILE($,#62,#46)")
      .with(46, "TOLERANCED_LENGTH_MEASURE(10.,$)")
      .with(62, "TOLERANCED_LENGTH_MEASURE(14.,$)")
      .with(50, "AXIS2_PLACEMENT_3D('',#51,$,$)")
      .with(51, "CARTESIAN_POINT('',(50.,40.,0.))");
  const Part turned = program.feature("CIRCULAR_PATTERN('RING',#3,(),#50,#40,90.,2,(),(),$,90.)").read();
  expect_box(turned.features[0].target, 15, 25, 33, 47);
  expect_box(turned.features[1].target, 43, 57, 5, 15);
  const Part parallel = program.feature("CIRCULAR_PATTERN('RING',#3,(),#50,#40,90.,2,(),(),$,0.)").read();
  expect_box(parallel.features[1].target, 45, 55, 3, 17);
}

TEST(StepNcPattern, RectangularWithMissingAndRelocatedMembers) {
  Program program = with_hole();
  program.with(42, "CARTESIAN_POINT('',(20.,20.,0.))")
      .with(52, "DIRECTION('',(1.,0.,0.))")
      .with(53, "TOLERANCED_LENGTH_MEASURE(15.,$)")
      .with(54, "TOLERANCED_LENGTH_MEASURE(12.,$)")
      .with(55, "DIRECTION('',(0.,1.,0.))")
      .with(56, "RECTANGULAR_OFFSET(#55,#57,1,3)")
      .with(57, "TOLERANCED_LENGTH_MEASURE(2.,$)")
      .with(58, "RECTANGULAR_OMIT(2,2)");
  const Part part =
      program.feature("RECTANGULAR_PATTERN('GRID',#3,(),#41,#40,#53,#52,2,3,#54,#55,(#56),(#58))").read();
  expect_centres(part, {{20, 20}, {35, 20}, {50, 22}, {20, 32}, {50, 32}});
  const Part row = program.feature("RECTANGULAR_PATTERN('GRID',#3,(),#41,#40,#53,#52,$,3,$,$,(),())").read();
  expect_centres(row, {{20, 20}, {35, 20}, {50, 20}});
  EXPECT_THAT(program.feature("RECTANGULAR_PATTERN('GRID',#3,(),#41,#40,#53,#52,2,3,$,$,(),())").error(),
              HasSubstr("row spacing"));
}

TEST(StepNcPattern, GeneralIsTheBaseAndACopyAtEachPlace) {
  const Part part = with_hole()
                        .feature("GENERAL_PATTERN('SOME',#3,(),#50,#40,(#52,#54))")
                        .with(52, "AXIS2_PLACEMENT_3D('',#53,$,$)")
                        .with(53, "CARTESIAN_POINT('',(10.,5.,0.))")
                        .with(54, "AXIS2_PLACEMENT_3D('',#55,$,$)")
                        .with(55, "CARTESIAN_POINT('',(-20.,0.,0.))")
                        .read();
  expect_centres(part, {{30, 40}, {60, 45}});
  EXPECT_THAT(all_diagnostics(part), HasSubstr("cut once"));
}

TEST(StepNcPattern, WhatCannotBeIsRefusedByName) {
  const auto error = [](const std::string& entity) { return with_hole().feature(entity).error(); };
  EXPECT_THAT(error("CIRCULAR_PATTERN('R',#3,(),#50,#40,90.,0,(),(),$,0.)"), HasSubstr("number of features"));
  EXPECT_THAT(error("CIRCULAR_PATTERN('R',#3,(),#50,#40,90.,1000000000,(),(),$,0.)"), HasSubstr("10000"));
  EXPECT_THAT(error("GENERAL_PATTERN('R',#3,(),#50,#20,(#21))"), HasSubstr("in a circle"));
  EXPECT_THAT(error("GENERAL_PATTERN('R',#3,(),#50,#40,())"), HasSubstr("no locations"));
  EXPECT_THAT(error("COMPOUND_FEATURE('C',#3,(),#50,#23,())"), HasSubstr("no elements"));
  EXPECT_THAT(error("CHAMFER('C',#3,(),#40,#40,0.7,#43)"), HasSubstr("deburr"));
}

/// A counterbore: 20 mm wide 3 mm deep, and under it 6 mm, placed in the compound.
Program with_counterbore() {
  return with_hole()
      .feature("COMPOUND_FEATURE('CB',#3,(),#50,#23,(#46,#40))")
      .with(42, "CARTESIAN_POINT('',(0.,0.,-3.))")
      .with(46, "ROUND_HOLE('',#3,(),$,#47,#62,$,#44)")
      .with(47, "PLANE('',#48)")
      .with(48, "AXIS2_PLACEMENT_3D('',#49,$,$)")
      .with(49, "CARTESIAN_POINT('',(0.,0.,-3.))");
}

TEST(StepNcCompound, DrillsTakeTheHoleOfTheirDiameter) {
  const Part part = with_counterbore().read();
  ASSERT_EQ(part.workplan.size(), 1U);
  const Feature& hole = part.features[0];
  EXPECT_EQ(hole.name, "HOLE");
  EXPECT_EQ(hole.hole_diameter, 6);
  EXPECT_EQ(hole.floor_z, -8);
  expect_centres(part, {{50, 40}});
}

TEST(StepNcCompound, CuttersTakeWhatTheyFitInto) {
  Program program = with_counterbore();
  program.with(2, "WORKPLAN('MAIN',(#11,#10),$,#4,$)")
      .with(11, "MACHINING_WORKINGSTEP('MILL',#7,#20,#70,$)")
      .with(70, "BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',2.,$,#71,#34,#35,$,$,$,$,2.,$,$,$)")
      .with(71, "MILLING_CUTTING_TOOL('T6',#72,(),$,$,$)")
      .with(72, "ENDMILL(#73,3,.RIGHT.,$,$)")
      .with(73, "MILLING_TOOL_DIMENSION(10.,$,$,25.,0.,$,$)");
  const Part part = program.read();
  ASSERT_EQ(part.workplan.size(), 2U);
  EXPECT_EQ(part.features[0].name, "CB");
  EXPECT_EQ(part.features[0].hole_diameter, 20);
  EXPECT_EQ(part.features[0].floor_z, -3);
  EXPECT_EQ(part.workplan[0].operation.retract_z, 2);
  EXPECT_EQ(part.features[1].hole_diameter, 6);
  EXPECT_EQ(part.features[1].top_z, -3);
}

/// What an element lists as its own operation goes before what fits.
TEST(StepNcCompound, ElementsNameTheirOperations) {
  const Part part = with_counterbore().with(46, "ROUND_HOLE('',#3,(#30),$,#47,#62,$,#44)").read();
  ASSERT_EQ(part.features.size(), 1U);
  EXPECT_EQ(part.features[0].hole_diameter, 20);
}

TEST(StepNcCompound, AnElementAloneLiesInItsCompound) {
  const Part part = with_counterbore().with(10, "MACHINING_WORKINGSTEP('WS1',#7,#40,#30,$)").read();
  expect_centres(part, {{50, 40}});
  EXPECT_EQ(part.features[0].floor_z, -8);
}

TEST(StepNcCompound, ElementsThatCannotBeMadeAreLeftOutByName) {
  const Part part = with_counterbore()
                        .feature("COMPOUND_FEATURE('CB',#3,(),#50,#23,(#46,#40,#80))")
                        .with(80, "CHAMFER('C',#3,(),#40,#46,0.7,#43)")
                        .read();
  EXPECT_EQ(part.features.size(), 1U);
  EXPECT_THAT(all_diagnostics(part), HasSubstr("a part of #20 COMPOUND_FEATURE is left out: "));
  EXPECT_THAT(all_diagnostics(part), HasSubstr("#80 CHAMFER"));
}

TEST(StepNcCompound, PatternsOfCompoundsAndCompoundsOfPatterns) {
  const Part pattern = with_counterbore()
                           .with(81, "CIRCULAR_PATTERN('RING',#3,(),#82,#20,180.,2,(),(),$,0.)")
                           .with(82, "AXIS2_PLACEMENT_3D('',#83,$,$)")
                           .with(83, "CARTESIAN_POINT('',(50.,30.,0.))")
                           .with(10, "MACHINING_WORKINGSTEP('WS1',#7,#81,#30,$)")
                           .read();
  expect_centres(pattern, {{50, 40}, {50, 20}});
  EXPECT_EQ(pattern.features[1].floor_z, -8);
  const Part compound = with_hole()
                            .feature("COMPOUND_FEATURE('C',#3,(),#50,#23,(#81))")
                            .with(42, "CARTESIAN_POINT('',(10.,0.,0.))")
                            .with(81, "CIRCULAR_PATTERN('RING',#3,(),#21,#40,90.,4,(),(),$,0.)")
                            .read();
  expect_centres(compound, {{60, 40}, {50, 50}, {40, 40}, {50, 30}});
}

TEST(StepNc, TaperedHolesAreRoundPocketsWithLeaningWalls) {
  Program program;
  program.feature("ROUND_HOLE('HOLE',#3,(),#28,#23,#62,#40,#41)").with(41, "FLAT_HOLE_BOTTOM()");
  const Part part =
      program.with(40, "DIAMETER_TAPER(#42)").with(42, "TOLERANCED_LENGTH_MEASURE(18.,$)").read();
  EXPECT_EQ(part.features[0].kind, FeatureKind::kClosedPocket);
  EXPECT_NEAR(std::tan(part.features[0].wall_slope.radians()), 0.2, 1e-12);
  expect_box(part.features[0].target, 40, 60, 30, 50);
  const Part by_angle = program.with(40, "ANGLE_TAPER(0.19739555984988)").read();
  EXPECT_NEAR(std::tan(by_angle.features[0].wall_slope.radians()), 0.2, 1e-9);
  EXPECT_THAT(program.with(40, "DIAMETER_TAPER(#42)").with(42, "TOLERANCED_LENGTH_MEASURE(22.,$)").error(),
              HasSubstr("widens downwards"));
  EXPECT_THAT(program.with(40, "ANGLE_TAPER(1.2)").error(), HasSubstr("comes to a point"));
  EXPECT_THAT(program.with(40, "ANGLE_TAPER(0.1)")
                  .with(30, "DRILLING($,$,'DRILL',$,$,#31,#34,#35,$,$,$,$,$,$)")
                  .error(),
              HasSubstr("milled, not drilled"));
}

TEST(StepNc, OutsideProfileRemovesTheRestOfTheStock) {
  Program p;
  p.feature("GENERAL_OUTSIDE_PROFILE('OUT',#3,(#30),#21,#23,$,#27)");
  const Feature f = p.read().features[0];
  EXPECT_EQ(f.kind, FeatureKind::kOutsideProfile);
  EXPECT_NEAR(area(f.target), 8000 - 1200, 1e-9);
  EXPECT_FALSE(contains(f.allowed, {50, 40}));
  EXPECT_TRUE(contains(f.allowed, {50, -100}));
}

TEST(StepNc, NestedWorkplansAreCutInOrder) {
  Program p;
  p.with(2, "WORKPLAN('MAIN',(#11,#10,#12),$,#4,$)")
      .with(11, "WORKPLAN('A',(#13),$,$,$)")
      .with(12, "WORKPLAN('B',(#14,#15),$,$,$)");
  for (const int id : {13, 14, 15})
    p.with(id, "MACHINING_WORKINGSTEP('WS" + std::to_string(id) + "',#7,#20,#30,$)");
  const Part part = p.read();
  std::string order;
  for (const Workingstep& step : part.workplan) order += step.name + " ";
  EXPECT_EQ(order, "WS13 WS1 WS14 WS15 ");
  EXPECT_EQ(part.features.size(), 1U);
}

TEST(StepNc, WorkplansInACircleAreRefused) {
  Program p;
  p.with(2, "WORKPLAN('MAIN',(#11),$,#4,$)").with(11, "WORKPLAN('A',(#2,#2),$,$,$)");
  EXPECT_THAT(p.error(), HasSubstr("WORKPLAN: "));
}

TEST(StepNc, StockMayBeACylinderOrARawPiece) {
  Program p;
  p.with(5, "RIGHT_CIRCULAR_CYLINDER('C',#6,20.,50.)");
  EXPECT_EQ(p.read().stock->plan.min, (Vec2{-50, -50}));
  p = Program().with(3, "WORKPIECE('WP',$,$,#80,$,#5,())").with(80, "WORKPIECE('RAW',$,$,$,$,#81,())");
  p.with(81, "BLOCK('B',#82,110.,90.,-25.)")
      .with(82, "AXIS2_PLACEMENT_3D('',#83,$,$)")
      .with(83, "CARTESIAN_POINT('',(-5.,-5.,2.))");
  const Part part = p.read();
  EXPECT_EQ(part.stock->plan.max, (Vec2{105, 85}));
  EXPECT_EQ(part.stock->z_top, 2);
  EXPECT_EQ(part.stock->z_bottom, -23) << "sizes may be negative";
  EXPECT_EQ(part.features[0].top_z, 2) << "the raw piece stands 2 mm higher";
  EXPECT_EQ(count_of(part, Severity::kWarning), 1);
}

TEST(StepNc, SecurityPlaneIsRelativeToTheSetUp) {
  Program p;
  p.with(9, "WORKPIECE_SETUP(#3,#85,$,$,())")
      .with(85, "AXIS2_PLACEMENT_3D('',#86,$,$)")
      .with(86, "CARTESIAN_POINT('',(100.,50.,12.))");
  const Part part = p.read();
  EXPECT_EQ(part.clearance_z, 18);
  EXPECT_THAT(all_diagnostics(part), HasSubstr("program zero is the workpiece's origin"));
}

TEST(StepNc, SecurityPlaneInsideTheStockIsNotUsed) {
  const Part part = Program().with(61, "CARTESIAN_POINT('',(0.,0.,-3.))").read();
  EXPECT_FALSE(part.clearance_z);
  EXPECT_EQ(part.safe_z(), 10);
}

TEST(StepNc, SpindleAndFeedInOtherUnitsAreRecognisedAndReported) {
  Part part = Program().with(34, "MILLING_TECHNOLOGY(400.,.TCP.,$,-1200.,$,$,$,$,$)").read();
  EXPECT_EQ(part.workplan[0].operation.cutting.spindle_rpm, 1200);
  EXPECT_EQ(part.workplan[0].operation.cutting.feed, MmPerMin::of(400));
  EXPECT_THAT(all_diagnostics(part), HasSubstr("read as rpm"));
  EXPECT_THAT(all_diagnostics(part), HasSubstr("read as mm/min"));
  part = Program().with(34, "MILLING_TECHNOLOGY($,.TCP.,100.,$,0.05,$,$,$,$)").read();
  const double rpm = 100000 / (kPi * 10);
  EXPECT_NEAR(*part.workplan[0].operation.cutting.spindle_rpm, rpm, 1e-9) << "cutting speed 100 m/min";
  EXPECT_NEAR(part.workplan[0].operation.cutting.feed->mm_per_min(), 0.05 * 3 * rpm, 1e-9) << "per tooth";
}

TEST(StepNc, OnlyALeftHandCutterTurningPositiveRunsCounterClockwise) {
  Program p;
  p.with(34, "MILLING_TECHNOLOGY(0.01,.TCP.,$,100.,$,$,$,$,$)");
  EXPECT_TRUE(p.read().workplan[0].operation.cutting.spindle_clockwise)
      << "a right-hand mill, whatever the sign";
  p.with(32, "ENDMILL(#33,3,.LEFT.,$,$)");
  EXPECT_FALSE(p.read().workplan[0].operation.cutting.spindle_clockwise);
}

TEST(StepNc, ToolsAreReadOnceAndNumbered) {
  Program p;
  p.with(2, "WORKPLAN('MAIN',(#10,#11,#12),$,#4,$)");
  for (const int k : {1, 2}) {
    p.with(10 + k, "MACHINING_WORKINGSTEP('WS',#7,#20,#" + std::to_string(90 + k) + ",$)");
    p.with(90 + k, "BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',$,$,#" + std::to_string(94 + k) +
                       ",#34,#35,$,$,$,$,2.,$,$,$)");
    p.with(94 + k, "MILLING_CUTTING_TOOL('ball nose',#97,(),$,$,$)");
  }
  p.with(97, "BALL_ENDMILL(#33,2,$,$,$)");
  const Part part = p.read();
  ASSERT_EQ(part.tools.size(), 2U);
  EXPECT_EQ(part.tools[1].kind, ToolKind::kBallEndMill);
  EXPECT_EQ(part.tools[1].corner_radius, 5);
  EXPECT_EQ(part.tools[1].number, 1);
  EXPECT_EQ(part.workplan[1].operation.tool, 1);
  EXPECT_EQ(part.workplan[2].operation.tool, 1);
}

TEST(StepNc, WhatCannotBeMachinedIsSkippedAndTheRestStays) {
  Program p;
  p.with(2, "WORKPLAN('MAIN',(#11,#10,#12,#13),$,#4,$)");
  p.with(11, "MACHINING_WORKINGSTEP('TAP IT',#7,#20,#90,$)")
      .with(90, "TAPPING($,$,'TAP',$,$,#31,#34,#35,$,$,$,$,$,$,.T.)");
  p.with(12, "MACHINING_WORKINGSTEP('NO FEATURE',#7,#99,#30,$)");
  p.with(13, "MACHINING_WORKINGSTEP('CHAMFER IT',#7,#98,#30,$)")
      .with(98, "CHAMFER('C',#3,(),#20,#20,0.7,#62)");
  const Part part = p.read();
  ASSERT_EQ(part.workplan.size(), 1U);
  EXPECT_EQ(part.workplan[0].name, "WS1");
  EXPECT_EQ(count_of(part, Severity::kSkipped), 3) << all_diagnostics(part);
  EXPECT_THAT(all_diagnostics(part),
              HasSubstr("'TAP IT' is left out: line 41: #90 TAPPING: threads are not cut"));
  EXPECT_THAT(all_diagnostics(part), HasSubstr("refers to #99, which is not in the file"));
  EXPECT_THAT(all_diagnostics(part), HasSubstr("CHAMFER: an edge is broken"));
}

TEST(StepNc, MissingEssentialsNameEntityAndLine) {
  EXPECT_EQ(Program().with(33, "MILLING_TOOL_DIMENSION($,$,$,25.,0.5,$,$)").error(),
            "t.p21:29: #33 MILLING_TOOL_DIMENSION: no diameter (argument 1); give one");
  EXPECT_EQ(Program().feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),$,#26,$,$,$)").error(),
            "t.p21:16: #20 CLOSED_POCKET: no feature boundary (argument 11); give one");
  EXPECT_EQ(Program().feature("CLOSED_POCKET('POCKET',#3,(#30),#21,$,(),$,#26,$,$,#27)").error(),
            "t.p21:16: #20 CLOSED_POCKET: no depth (argument 5); give one");
  EXPECT_THAT(Program().with(25, "CARTESIAN_POINT('',(0.,0.,5.))").error(),
              HasSubstr("#20 CLOSED_POCKET: its depth plane (z 5) is not below its top (z 0)"));
}

TEST(StepNc, MissingNonEssentialsGetDefaultsAndOneNoteForAll) {
  Program p;
  p.with(30, "BOTTOM_AND_SIDE_MILLING($,$,'OP',$,$,#31,$,$,$,$,$,$,$,$,$,$)")
      .with(33, "MILLING_TOOL_DIMENSION(10.,$,$,$,$,$,$)");
  p.with(2, "WORKPLAN('MAIN',(#10,#11),$,$,$)").with(11, "MACHINING_WORKINGSTEP('WS2',$,#20,#90,$)");
  p.with(90, "BOTTOM_AND_SIDE_MILLING($,$,'OP2',$,$,#31,$,$,$,$,$,$,$,$,$,$)");
  const Part part = p.read();
  EXPECT_EQ(part.workplan.size(), 2U);
  const std::string notes = all_diagnostics(part);
  EXPECT_THAT(notes, HasSubstr("#30 BOTTOM_AND_SIDE_MILLING, #90 BOTTOM_AND_SIDE_MILLING: no cutting depth; "
                               "the planner's default is used"));
  EXPECT_THAT(notes, HasSubstr("no technology"));
  EXPECT_THAT(notes,
              HasSubstr("#33 MILLING_TOOL_DIMENSION: no edge radius; the cutter is taken as flat-ended"));
  EXPECT_LE(part.diagnostics.items().size(), 5U) << notes;
}

TEST(StepNc, OtherSchemasAreRefusedByName) {
  EXPECT_THAT(Program().schema("INTEGRATED_CNC_SCHEMA").error(), HasSubstr("AP238"));
  EXPECT_THAT(Program().schema("AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }").error(),
              HasSubstr("a STEP solid"));
}

TEST(StepNc, TiltedSetUpsAndFeaturesAreRefusedByName) {
  Program p;
  p.with(84, "DIRECTION('',(1.,0.,0.))").with(85, "AXIS2_PLACEMENT_3D('',#22,#84,$)");
  EXPECT_THAT(Program(p).with(4, "SETUP('S',#85,#7,(#9))").error(),
              HasSubstr("#4 SETUP: the set-up is tilted"));
  EXPECT_THAT(Program(p).with(9, "WORKPIECE_SETUP(#3,#85,$,$,())").error(),
              HasSubstr("#9 WORKPIECE_SETUP: the workpiece is tilted"));
  EXPECT_THAT(Program(p).feature("CLOSED_POCKET('POCKET',#3,(#30),#85,#23,(),$,#26,$,$,#27)").error(),
              HasSubstr("#20 CLOSED_POCKET: its placement is tilted"));
}

TEST(StepNc, DepthsThatWouldEndBelowTheStockAreReadAsAbsolute) {
  Program p;  // two pockets, one in the other, with absolute depths
  p.with(2, "WORKPLAN('MAIN',(#10,#11),$,#4,$)").with(11, "MACHINING_WORKINGSTEP('WS2',#7,#70,#30,$)");
  p.with(70, "CLOSED_POCKET('INNER',#3,(#30),#71,#73,(),$,#26,$,$,#76)")
      .with(71, "AXIS2_PLACEMENT_3D('',#72,$,$)");
  p.with(72, "CARTESIAN_POINT('',(0.,0.,-9.))")
      .with(73, "PLANE('',#74)")
      .with(74, "AXIS2_PLACEMENT_3D('',#75,$,$)");
  p.with(75, "CARTESIAN_POINT('',(0.,0.,-15.))")
      .with(76, "CIRCULAR_CLOSED_PROFILE(#28,#77)")
      .with(77, "TOLERANCED_LENGTH_MEASURE(16.,$)");
  const Part part = p.read();
  EXPECT_EQ(part.features[0].floor_z, -5);
  EXPECT_EQ(part.features[1].floor_z, -15);
  EXPECT_EQ(part.features[1].top_z, -5) << "what the first pocket left, not the placement's -9";
  EXPECT_THAT(all_diagnostics(part), HasSubstr("the depths of the whole file are taken as absolute z"));
  EXPECT_EQ(count_of(part, Severity::kWarning), 1);
}

TEST(StepNc, NoStockButAFaceShowsHowFarItReaches) {
  Program p;
  p.with(3, "WORKPIECE('WP',$,$,$,$,$,())").feature("PLANAR_FACE('FACE',#3,(#30),#21,#23,$,$,#27,())");
  const Part part = p.read();
  ASSERT_TRUE(part.stock);
  expect_box({Region::from_valid_loops(part.features[0].target[0].outer(), {})}, 20, 80, 30, 50);
  EXPECT_EQ(part.stock->z_top, 0);
  EXPECT_EQ(part.stock->z_bottom, -5);
  EXPECT_TRUE(contains(part.features[0].allowed, {0, 0}));
}

TEST(StepNc, NoStockAndNoFaceIsSolidAround) {
  const Part part = Program().with(3, "WORKPIECE('WP',$,$,$,$,$,())").read();
  EXPECT_FALSE(part.stock);
  EXPECT_THAT(Program()
                  .with(3, "WORKPIECE('WP',$,$,$,$,$,())")
                  .feature("PLANAR_FACE('FACE',#3,(#30),#21,#23,$,$,$,())")
                  .error(),
              HasSubstr("need the size of the stock"));
}

TEST(StepNc, SharedReferencesDoNotMultiply) {
  // Each composite curve uses the next one twice: 2^16 copies of the innermost.
  Program p;
  p.with(27, "GENERAL_CLOSED_PROFILE($,#100)");
  for (int k = 0; k < 40; ++k)
    p.with(100 + k,
           "COMPOSITE_CURVE('',(#" + std::to_string(101 + k) + ",#" + std::to_string(101 + k) + "),.F.)");
  EXPECT_THAT(p.error(), HasSubstr("nested more than 16 deep"));
}

}  // namespace
}  // namespace clearcut::read::stepnc
