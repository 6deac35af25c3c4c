// Toolpaths that a program states: what is read of them, and what is said of the rest.
#include "model/part.h"
#include "read/stepnc/test_program.h"

namespace clearcut::read::stepnc::testing {
namespace {

/// A program whose operation has the toolpaths `list`, "(#81,#82)", by an explicit strategy where `is_explicit`.
Program with_path(const std::string& list, bool is_explicit = true) {
  Program p;
  p.with(30, "BOTTOM_AND_SIDE_ROUGH_MILLING(#80,$,'OP',8.,$,#31,#34,#35,$,$,$,#37,2.,$,$,$)");
  if (is_explicit) p.with(37, "EXPLICIT_STRATEGY($,$)");
  p.with(33, "MILLING_TOOL_DIMENSION(10.,$,$,25.,0.,$,$)");
  p.with(80, "TOOLPATH_LIST(" + list + ")");
  p.with(81, "CUTTER_LOCATION_TRAJECTORY(.T.,.CONTACT.,$,$,$,$,#85,$,$)");
  p.with(85, "POLYLINE('',(#90,#91,#92))");
  p.with(90, "CARTESIAN_POINT('',(30.,40.,-5.))").with(91, "CARTESIAN_POINT('',(70.,40.,-5.))");
  return p.with(92, "CARTESIAN_POINT('',(70.,42.,-5.))");
}

const StatedPath& path_in(const Part& part) {
  return part.workplan.at(0).stated_path.value();
}

std::string ends_of(const StatedPath& path) {
  std::string text;
  for (const StatedMove& move : path.moves) {
    const auto number = [](double value) { return std::to_string(std::lround(value * 100)) + " "; };
    text += number(move.path.to.x) + number(move.path.to.y) + number(move.z_to) + name_of(move.kind) + "; ";
  }
  return text;
}

TEST(StatedToolpaths, APolylineIsTheTipsWayInTheFrameOfTheFeature) {
  Program p = with_path("(#81)");
  EXPECT_EQ(ends_of(path_in(p.read())), "7000 4000 -500 cut; 7000 4200 -500 cut; ");
  EXPECT_TRUE(path_in(p.read()).is_explicit);
  p.with(22, "CARTESIAN_POINT('',(1.,2.,0.))");
  EXPECT_EQ(ends_of(path_in(p.read())), "7100 4200 -500 cut; 7100 4400 -500 cut; ");
  EXPECT_EQ(all_diagnostics(p.read()).find("not followed: TOOLPATH"), std::string::npos);
}

/// The cutter cuts as far as its radius beside its centre: such a path lies on its feature.
TEST(StatedToolpaths, APathWhoseCentreLiesBesideTheFeatureIsInItsFrameNevertheless) {
  Program p = with_path("(#81)");
  p.with(22, "CARTESIAN_POINT('',(0.,6.,0.))").with(92, "CARTESIAN_POINT('',(60.,53.,-5.))");
  p.with(90, "CARTESIAN_POINT('',(30.,53.,-5.))").with(91, "CARTESIAN_POINT('',(70.,53.,-5.))");
  EXPECT_EQ(ends_of(path_in(p.read())), "7000 5900 -500 cut; 6000 5900 -500 cut; ");
  EXPECT_EQ(all_diagnostics(p.read()).find("in the coordinates of the workpiece"), std::string::npos);
}

TEST(StatedToolpaths, AnyOtherStrategyLeavesTheChoiceOpen) {
  EXPECT_FALSE(path_in(with_path("(#81)", false).read()).is_explicit);
}

TEST(StatedToolpaths, ArcsKeepTheirCentreAndRunBackwardsWhereAsked) {
  Program p = with_path("(#81)");
  p.with(85, "TRIMMED_CURVE('',#86,(#90),(#91),.T.,.CARTESIAN.)").with(86, "CIRCLE('',#87,20.)");
  p.with(87, "AXIS2_PLACEMENT_3D('',#88,$,$)").with(88, "CARTESIAN_POINT('',(50.,40.0004,-5.))");
  const StatedMove arc = path_in(p.read()).moves.at(0);
  EXPECT_EQ(arc.path, Edge::arc({30, 40}, {70, 40}, {50, 40.0004}, Turn::kCounterClockwise));
  p.with(81, "CUTTER_LOCATION_TRAJECTORY(.T.,.CONTACT.,$,$,$,.F.,#85,$,$)");
  EXPECT_EQ(path_in(p.read()).moves.at(0).path,
            Edge::arc({70, 40}, {30, 40}, {50, 40.0004}, Turn::kClockwise));
}

TEST(StatedToolpaths, FeedsAreThoseOfTheTrajectoryAndRapidsAreRapids) {
  Program p = with_path("(#81)");
  EXPECT_FALSE(path_in(p.read()).moves.at(0).feed.has_value()) << "that of the operation";
  p.with(82, "MILLING_TECHNOLOGY(0.005,.TCP.,$,-100.,$,$,$,$,$)");
  p.with(81, "CUTTER_LOCATION_TRAJECTORY(.T.,.CONTACT.,$,#82,$,$,#85,$,$)");
  EXPECT_EQ(path_in(p.read()).moves.at(0).feed, MmPerMin::of(300));
  p.with(81, "CUTTER_LOCATION_TRAJECTORY(.T.,.CONTACT.,POSITIVE_RATIO_MEASURE(0.5),$,$,$,#85,$,$)");
  EXPECT_EQ(path_in(p.read()).moves.at(0).feed, MmPerMin::of(300)) << "half of the operation's 600";
  p.with(81, "CUTTER_LOCATION_TRAJECTORY(.T.,.NON_CONTACT.,SPEED_NAME(.RAPID.),$,$,$,#85,$,$)");
  EXPECT_EQ(path_in(p.read()).moves.at(0).kind, MoveKind::kRapid);
  p.with(81, "CUTTER_LOCATION_TRAJECTORY(.T.,.CONTACT.,#83,$,$,$,#85,$,$)");
  p.with(83, "TOOLPATH_SPEED(#84)")
      .with(84, "B_SPLINE_CURVE_WITH_KNOTS('',1,(#93,#94),$,$,$,(2,2),(0.,1.),$)");
  p.with(93, "CARTESIAN_POINT('',(0.004))").with(94, "CARTESIAN_POINT('',(0.002))");
  EXPECT_EQ(path_in(p.read()).moves.at(0).feed, MmPerMin::of(120)) << "the least of the profile";
  EXPECT_NE(all_diagnostics(p.read()).find("the speed varies along the curve"), std::string::npos);
}

TEST(StatedToolpaths, StopsDwellAfterTheMoveBeforeThem) {
  Program p = with_path("(#81,#82)");
  p.with(82, "FEEDSTOP(.T.,.CONTACT.,$,$,$,1.5)");
  EXPECT_EQ(path_in(p.read()).moves.back().dwell_s, 1.5);
}

TEST(StatedToolpaths, TheWayOfContactIsTheTipsUnderAFlatEndAlone) {
  Program p = with_path("(#81)");
  p.with(81, "CUTTER_CONTACT_TRAJECTORY(.T.,.CONTACT.,$,$,$,$,#85,$,.FRONT.)");
  EXPECT_EQ(path_in(p.read()).moves.size(), 2U);
  p.with(81, "CUTTER_CONTACT_TRAJECTORY(.T.,.CONTACT.,$,$,$,$,#85,$,.SIDE.)");
  EXPECT_NE(p.error().find("on which side the wall is"), std::string::npos) << p.error();
  p.with(81, "CUTTER_CONTACT_TRAJECTORY(.T.,.CONTACT.,$,$,$,$,#85,$,$)");
  p.with(33, "MILLING_TOOL_DIMENSION(10.,$,$,25.,1.,$,$)");
  EXPECT_NE(p.error().find("flat"), std::string::npos) << p.error();
}

TEST(StatedToolpaths, AHelixIsWhatItsPointsAgreeWith) {
  Program p = with_path("(#81)");
  // A quarter turn about (50, 40) from (60, 40, -1) to (50, 50, -2), its middle half a micron off.
  p.with(85, "POLYLINE('HELIX CCW 50.0 40.0',(#90,#91,#92))").with(90, "CARTESIAN_POINT('',(60.,40.,-1.))");
  p.with(91, "CARTESIAN_POINT('',(57.071068,47.071068,-1.5))").with(92, "CARTESIAN_POINT('',(50.,50.,-2.))");
  const StatedPath path = path_in(p.read());
  ASSERT_EQ(path.moves.size(), 1U);
  EXPECT_EQ(path.moves[0].path, Edge::arc({60, 40}, {50, 50}, {50, 40}, Turn::kCounterClockwise));
  EXPECT_EQ(path.moves[0].kind, MoveKind::kRamp);
  p.with(91, "CARTESIAN_POINT('',(57.0,47.0,-1.5))");
  EXPECT_EQ(path_in(p.read()).moves.size(), 2U) << "its name says another curve than its points";
}

TEST(StatedToolpaths, APathBesideItsFeatureIsThatOfTheWorkpiece) {
  Program p = with_path("(#81)");
  p.with(22, "CARTESIAN_POINT('',(50.,40.,0.))").with(29, "CARTESIAN_POINT('',(0.,0.,0.))");
  const Part part = p.read();
  EXPECT_EQ(ends_of(path_in(part)), "7000 4000 -500 cut; 7000 4200 -500 cut; ");
  EXPECT_NE(all_diagnostics(part).find("in the coordinates of the workpiece"), std::string::npos);
}

TEST(StatedToolpaths, WhatCannotBeFollowedIsNamed) {
  Program p = with_path("(#81)");
  p.with(81, "CUTTER_LOCATION_TRAJECTORY(.T.,.CONTACT.,$,$,$,$,#85,#85,$)");
  EXPECT_NE(all_diagnostics(p.read()).find("its_toolaxis"), std::string::npos) << "a tilted tool";
  p.with(81, "AXIS_TRAJECTORY(.T.,.CONTACT.,$,$,$,$,('X'),(#85))");
  EXPECT_NE(p.error().find("#81 AXIS_TRAJECTORY: toolpaths of this kind are not followed"), std::string::npos)
      << p.error();
  Program other = with_path("(#81)", false);
  other.with(81, "AXIS_TRAJECTORY(.T.,.CONTACT.,$,$,$,$,('X'),(#85))");
  const Part part = other.read();
  EXPECT_FALSE(part.workplan.at(0).stated_path.has_value());
  EXPECT_NE(all_diagnostics(part).find("its toolpath is not followed"), std::string::npos);
}

}  // namespace
}  // namespace clearcut::read::stepnc::testing
