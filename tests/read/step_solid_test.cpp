// STEP solids: the same regions as the drawings of the same part, what is left out, and the whole
// job.
#include "read/step_solid/step_solid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/file.h"
#include "base/random.h"
#include "base/units.h"
#include "pipeline/run.h"
#include "pipeline/texts.h"
#include "post/part/part_writers.h"
#include "read/common/curve_fit.h"
#include "read/common/moved_part.h"
#include "read/job/read_part.h"
#include "read/step_solid/floor_sweep.h"
#include "read/step_solid/height_map.h"
#include "read/step_solid/solid_model.h"
#include "resolve/resolve.h"
#include "support/plans.h"
#include "support/same_regions.h"
#include "support/solids.h"

namespace clearcut {
namespace {

using test_support::boundary_gap;
using test_support::circle_area;
using test_support::example;
using test_support::refusal;
using test_support::refused;
using test_support::rounded_area;
using test_support::with_tool;
using ::testing::HasSubstr;

std::string skipped(const Part& part) {
  std::string all;
  for (const Diagnostic& item : part.diagnostics.items())
    if (item.severity == Severity::kSkipped) all += item.what + "\n";
  return all;
}

TEST(StepSolid, BracketIsTheSameRegionAsInEveryOtherFormat) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const Part solid = read::read_part(example("bracket.step"), {});
  ASSERT_EQ(solid.features.size(), 1u);
  EXPECT_EQ(solid.features[0].kind, FeatureKind::kClosedPocket);
  EXPECT_EQ(skipped(solid), "");
  ASSERT_TRUE(solid.stock);
  EXPECT_NEAR(solid.stock->plan.min.x, -10, 1e-6);
  EXPECT_NEAR(solid.stock->plan.max.y, 60, 1e-6);
  EXPECT_NEAR(solid.stock->z_bottom, -15, 1e-6);
  for (const char* name : {"bracket.json", "bracket.dxf", "bracket.svg"}) {
    const Part drawn = read::read_part(example(name), {});
    EXPECT_NEAR(solid.features[0].top_z, drawn.features[0].top_z, 1e-6) << name;
    EXPECT_NEAR(solid.features[0].floor_z, drawn.features[0].floor_z, 1e-6) << name;
    EXPECT_LT(boundary_gap(solid.features[0].target, drawn.features[0].target), 0.001) << name;
    EXPECT_LT(boundary_gap(solid.features[0].allowed, drawn.features[0].allowed), 0.001) << name;
    EXPECT_NEAR(area(solid.features[0].target), area(drawn.features[0].target), 1e-3) << name;
  }
}

/// The solid as a STEP-NC program, printed and read again: still the same regions.
TEST(StepSolid, BracketIsTheSameRegionAsItsStepNcProgram) {
  SKIP_WITHOUT_OPEN_CASCADE();
  Part solid = resolve::prepare(read::read_part(example("bracket.step"), {}), with_tool(6));
  const Part program = read::read_part_text(post::write_stepnc(solid), "bracket.stpnc", {});
  ASSERT_EQ(program.features.size(), 1u);
  EXPECT_LT(boundary_gap(solid.features[0].target, program.features[0].target), 0.001);
}

/// Some programs write planes and cylinders as splines, too.
TEST(StepSolid, FlatSplinesAreFloorsAndWalls) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const Part plain = read::read_part(example("nested.step"), {});
  const Part splines = read::read_part(example("nested_nurbs.step"), {});
  EXPECT_EQ(skipped(splines), "");
  ASSERT_EQ(splines.features.size(), plain.features.size());
  for (std::size_t i = 0; i < plain.features.size(); ++i) {
    const Feature &one = plain.features[i], &other = splines.features[i];
    EXPECT_EQ(other.kind, one.kind);
    EXPECT_NEAR(other.top_z, one.top_z, 1e-6);
    EXPECT_NEAR(other.floor_z, one.floor_z, 1e-6);
    EXPECT_LT(boundary_gap(other.target, one.target), 0.005);
    EXPECT_LT(boundary_gap(other.allowed, one.allowed), 0.005);
  }
}

/// See examples/solids/write_solids.cpp for the measures.
TEST(StepSolid, NestedPocketsBossOpenSideAndHoleAreFound) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const Part part = read::read_part(example("nested.step"), {});
  EXPECT_EQ(skipped(part), "");
  ASSERT_EQ(part.features.size(), 4u);
  const Feature& notch = part.features[0];
  EXPECT_EQ(notch.kind, FeatureKind::kOpenPocket);
  EXPECT_NEAR(notch.floor_z, -4, 1e-9);
  EXPECT_NEAR(area(notch.target), 25 * 40 - (4 - kPi) * 36 / 2, 1e-3);
  // Open beyond the stock, where nothing stands.
  EXPECT_TRUE(contains(notch.allowed, {500, 40}));
  EXPECT_TRUE(contains(notch.allowed, {-500, 40}));
  EXPECT_FALSE(contains(notch.allowed, {80, 40}));
  EXPECT_FALSE(contains(notch.allowed, {109, 61}));

  const Feature& upper = part.features[1];
  EXPECT_EQ(upper.kind, FeatureKind::kClosedPocket);
  EXPECT_NEAR(upper.floor_z, -6, 1e-9);
  EXPECT_NEAR(upper.top_z, 0, 1e-9);
  // The lower pocket's opening belongs to it; the boss does not.
  EXPECT_NEAR(area(upper.target), rounded_area(60, 60, 6) - circle_area(5), 1e-6);
  ASSERT_EQ(upper.target.size(), 1u);
  EXPECT_EQ(upper.target[0].islands().size(), 1u);

  const Feature& lower = part.features[2];
  EXPECT_EQ(lower.kind, FeatureKind::kClosedPocket);
  EXPECT_NEAR(lower.top_z, -6, 1e-9);
  EXPECT_NEAR(lower.floor_z, -12, 1e-9);
  EXPECT_NEAR(area(lower.target), rounded_area(32, 28, 6), 1e-6);

  const Feature& hole = part.features[3];
  EXPECT_EQ(hole.kind, FeatureKind::kRoundHole);
  EXPECT_TRUE(hole.through);
  EXPECT_NEAR(hole.top_z, -12, 1e-9);
  EXPECT_NEAR(hole.floor_z, -20.5, 1e-9);
  EXPECT_NEAR(hole.hole_diameter.value_or(0), 12, 1e-9);
}

const Feature* feature_at(const Part& part, double floor_z) {
  for (const Feature& feature : part.features)
    if (std::abs(feature.floor_z - floor_z) < 1e-6) return &feature;
  return nullptr;
}

TEST(StepSolid, WhatACutterFromAboveCannotMakeIsNamed) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const Part part = read::read_part(example("awkward.step"), {});
  const std::string left_out = skipped(part);
  EXPECT_THAT(left_out, HasSubstr("cylinder, x 67.5..72.5"));
  EXPECT_THAT(left_out, HasSubstr("1 floor(s) look along -Z"));
  EXPECT_THAT(left_out, HasSubstr("1 floor(s) look along -X"));
  EXPECT_THAT(left_out, HasSubstr("lies under an overhang"));
  EXPECT_THAT(left_out, HasSubstr("(cone, x 59..81, y 4..26, z -3..0) is neither"));
}

/// What the solid has and the program does not make counts in the verdict, face by face.
TEST(StepSolid, WhatIsLeftOutIsAnOpenCondition) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const Part part = read::read_part(example("awkward.step"), {});
  std::string doubts;
  for (const Diagnostic& item : part.diagnostics.items())
    if (item.condition == "left-out") doubts += item.what + "\n";
  EXPECT_THAT(doubts, HasSubstr("neither flat and level nor upright"));
  EXPECT_THAT(doubts, HasSubstr("under an overhang"));
  EXPECT_THAT(doubts, HasSubstr("another set-up"));
  EXPECT_THAT(doubts, HasSubstr("the cone at the end of round_hole_2 is not cut"));
  const PlanResult result = pipeline::plan_part(part, with_tool(5));
  const std::vector<Condition>& conditions = result.findings.conditions;
  EXPECT_TRUE(std::any_of(conditions.begin(), conditions.end(),
                          [](const Condition& one) { return one.name == "left-out" && one.met_by.empty(); }));
  const Part whole = read::read_part(example("nested.step"), {});
  for (const Diagnostic& item : whole.diagnostics.items()) EXPECT_NE(item.condition, "left-out") << item.what;
}

/// The picture hatches the cone in its place, with the zero where it is asked, and nothing on a whole part.
TEST(StepSolid, WhatIsLeftOutIsHatchedInThePicture) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const Part part = read::with_zero_at(read::read_part(example("awkward.step"), {}), {10, 20, 0});
  EXPECT_TRUE(contains(part.left_out, Vec2{60.5 - 10, 15 - 20}));
  EXPECT_FALSE(contains(part.left_out, Vec2{2 - 10, 2 - 20}));
  EXPECT_THAT(pipeline::write_picture(pipeline::plan_part(part, with_tool(5))),
              ::testing::AllOf(HasSubstr("class=\"left-out\""),
                               HasSubstr("the part has a face here that is left out")));
  const Part whole = read::read_part(example("nested.step"), {});
  EXPECT_TRUE(whole.left_out.empty());
  EXPECT_THAT(pipeline::write_picture(pipeline::plan_part(whole, with_tool(5))),
              ::testing::Not(HasSubstr("left-out")));
}

/// Another set-up of the job makes what looks another way; what no set-up makes stays a condition.
TEST(StepSolid, OtherSetUpsMakeWhatLooksAnotherWay) {
  SKIP_WITHOUT_OPEN_CASCADE();
  ReadOptions options;
  options.solid.has_other_setups = true;
  const Part part = read::read_part(example("awkward.step"), options);
  std::string doubts;
  for (const Diagnostic& item : part.diagnostics.items())
    if (item.condition == "left-out") doubts += item.what + "\n";
  EXPECT_EQ(std::count(doubts.begin(), doubts.end(), '\n'), 2) << doubts;
  EXPECT_THAT(doubts, HasSubstr("neither flat and level nor upright"));
  EXPECT_THAT(doubts, HasSubstr("the cone at the end of"));
}

/// What is said of the ends of holes of the awkward solid with one drill at hand, "" for nothing.
std::string ends_with(double diameter, std::optional<double> degrees, Part& part) {
  ReadOptions options;
  Tool drill;
  drill.kind = ToolKind::kDrill;
  drill.diameter = diameter;
  if (degrees) drill.tip_angle = Radians::of_degrees(*degrees);
  options.solid.tools = {drill};
  part = read::read_part(example("awkward.step"), options);
  std::string said;
  for (const Diagnostic& item : part.diagnostics.items())
    if (!item.condition.empty() &&
        (item.what.find("the cone at") == 0 || item.what.find("the floor of") == 0 ||
         item.what.find("the point of the drill") == 0 || item.what.find("below the flat floor of") == 0))
      said += item.what + "\n";
  return said;
}

/// The hole of 6 mm ends in a cone 2 mm high below z -12, that of 16 mm on a flat floor at z -10.
TEST(StepSolid, HolesEndAsTheyAreDrawnOrItIsSaid) {
  SKIP_WITHOUT_OPEN_CASCADE();
  Part part;
  const double degrees = 2 * std::atan(1.5) * 180 / kPi;
  EXPECT_EQ(ends_with(6, degrees, part), "");
  const Feature* pointed = feature_at(part, -14);
  ASSERT_TRUE(pointed && pointed->hole);
  EXPECT_NEAR(pointed->hole->full_z, -12, 1e-6);
  for (const std::optional<double> other : {std::optional<double>(), std::optional<double>(118)})
    EXPECT_THAT(ends_with(6, other, part),
                HasSubstr("the cone at the end of round_hole_2 has another angle"));
  const std::string flat = ends_with(16, std::nullopt, part);
  EXPECT_THAT(flat, HasSubstr("the floor of round_hole is flat and keeps the cone"));
  EXPECT_THAT(flat, HasSubstr("the cone at the end of round_hole_2 is not cut"));
  const std::string deeper = ends_with(16, 118, part);
  EXPECT_THAT(deeper, ::testing::Not(HasSubstr("is flat")));
  EXPECT_THAT(deeper,
              HasSubstr("the point of the drill goes below the flat floor of round_hole, up to 4.807 mm"));
  EXPECT_THAT(ends_with(16, 60, part),
              HasSubstr("below the flat floor of round_hole the point of the drill goes "
                        "through what is left of the solid"));
}

/// The full width reaches down to where the cone begins, in the program too.
TEST(StepSolid, AHoleWithAConeIsDrilledByThePointDeeper) {
  SKIP_WITHOUT_OPEN_CASCADE();
  Part part;
  ends_with(6, std::nullopt, part);
  const PlanResult result =
      pipeline::plan_part(part, test_support::plan_options_with({"endmill:5", "drill:6"}));
  EXPECT_LE(result.findings.all.gouge_mm, 0.001);
  EXPECT_NE(result.program.find("Z-13.802"), std::string::npos) << result.program.substr(0, 3000);
}

TEST(StepSolid, TheRestOfAnAwkwardSolidIsFoundAllTheSame) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const Part part = read::read_part(example("awkward.step"), {});
  ASSERT_EQ(part.features.size(), 4u);
  const Feature *pocket = feature_at(part, -8), *sunk = feature_at(part, -10),
                *drilled = feature_at(part, -12), *corner = feature_at(part, -30.5);
  ASSERT_TRUE(pocket && sunk && drilled && corner);
  EXPECT_EQ(pocket->kind, FeatureKind::kClosedPocket);
  EXPECT_NEAR(area(pocket->target), rounded_area(40, 40, 6), 0.01);
  EXPECT_EQ(sunk->kind, FeatureKind::kRoundHole);
  EXPECT_NEAR(sunk->hole_diameter.value_or(0), 16, 0.001);
  EXPECT_EQ(drilled->kind, FeatureKind::kRoundHole);
  EXPECT_NEAR(drilled->hole_diameter.value_or(0), 6, 0.001);
  EXPECT_FALSE(drilled->through);
  EXPECT_EQ(corner->kind, FeatureKind::kOutsideProfile);
  EXPECT_TRUE(corner->through);
  EXPECT_NEAR(area(corner->target), 9 * 9 / 2.0, 0.01);
  EXPECT_TRUE(contains(corner->allowed, {118, 58}));
  EXPECT_FALSE(contains(corner->allowed, {100, 50}));
}

/// Plans the whole solid and expects a clean certificate of every feature whose walls close.
void expect_clean_pockets(const std::string& name, double tool, std::size_t closed) {
  const PlanResult result = pipeline::plan_part(read::read_part(example(name), {}), with_tool(tool));
  ASSERT_EQ(result.findings.features.size(), result.part.features.size()) << name;
  std::size_t checked = 0;
  for (std::size_t i = 0; i < result.part.features.size(); ++i) {
    const Feature& feature = result.part.features[i];
    const auto& figures = result.findings.features[i].figures;
    EXPECT_GT(figures.feed_mm, 10) << name << ": " << feature.name;
    EXPECT_LE(figures.uncut_thickness_mm, 0.01) << name << ": " << feature.name;
    EXPECT_EQ(figures.rapid_in_material, 0) << name << ": " << feature.name;
    if (feature.kind != FeatureKind::kClosedPocket && feature.kind != FeatureKind::kRoundHole) continue;
    EXPECT_TRUE(figures.clean) << name << ": " << feature.name;
    ++checked;
  }
  EXPECT_EQ(checked, closed) << name;
  EXPECT_TRUE(result.findings.all.clean) << name;
}

TEST(StepSolid, ThePlansOfTheExamplesAreCertifiedClean) {
  SKIP_WITHOUT_OPEN_CASCADE();
  expect_clean_pockets("bracket.step", 6, 1);
  expect_clean_pockets("nested.step", 8, 3);
  expect_clean_pockets("awkward.step", 5, 3);
}

const std::string kHead =
    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
    "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n";

TEST(StepSolid, WithoutTheComponentTheMessageNamesThePackage) {
  if (read::solids_can_be_read()) GTEST_SKIP() << "built with Open CASCADE";
  EXPECT_THAT(refusal(read_file(example("bracket.step").string())), HasSubstr("libocct-data-exchange-dev"));
}

TEST(StepSolid, FilesWithoutSolidAreRefusedInOneLine) {
  SKIP_WITHOUT_OPEN_CASCADE();
  EXPECT_THAT(refusal(kHead + "#1=CARTESIAN_POINT('',(0.,0.,0.));\nENDSEC;\nEND-ISO-10303-21;\n"),
              HasSubstr("no solid"));
  EXPECT_THAT(refusal(kHead + "#1=CARTESIAN_POINT('',(0.,0."), HasSubstr("s.step:"));
  EXPECT_THAT(refusal(kHead), HasSubstr("s.step:"));
}

/// Damage of every kind is read or refused in one line, and always ends, whatever the kernel does.
TEST(StepSolid, DamagedFilesAreReadOrRefused) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const std::string original = read_file(example("bracket.step").string());
  const std::size_t data = original.find("DATA;");
  const char* pieces[] = {"$", "*", "'", "(", ")", "#", "0", "-", ".", ",", "1e9", "#1", "", "\n", "9"};
  int read = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    Random random(seed);
    std::string text = original;
    text.replace(data + 10 + random.below(text.size() - data - 100), random.below(6),
                 pieces[random.below(15)]);
    SCOPED_TRACE(seed);
    const std::string answer = refusal(text);
    ++(answer == "not refused" ? read : refused);
  }
  EXPECT_GT(read, 5);
  EXPECT_GT(refused, 10);
}

Path circle_from(double angle, double radius) {
  const Vec2 a = direction_of(angle) * radius;
  return {Edge::arc(a, -a, {}, Turn::kClockwise), Edge::arc(-a, a, {}, Turn::kClockwise)};
}

TEST(HeightMap, BoxesOfCurvedFacesEndWithTheSolid) {
  read::SolidModel solid;
  solid.plan = {{0, 0}, {40, 20}};
  solid.z_bottom = -5;
  read::SolidFace face;
  face.number = 1;
  face.surface = "free surface";
  face.facing = read::Facing::kMixed;
  face.plan = {{10, -0.03}, {20, 8}};
  solid.faces = {face};
  const read::HeightMap map(solid, "bulge", {});
  ASSERT_EQ(map.cells().size(), 1u);
  const Box where = box(map.cells()[0].area);
  EXPECT_EQ(where.min.y, 0);
  EXPECT_EQ(where.max.y, 8);
}

/// A rod that lies at 45 degrees: it covers its shadow, not the box of that.
TEST(HeightMap, CurvedFacesCoverTheirShadows) {
  read::SolidModel solid;
  solid.plan = {{0, 0}, {40, 40}};
  solid.z_bottom = -5;
  read::SolidFace face;
  face.number = 1;
  face.surface = "cylinder";
  face.facing = read::Facing::kMixed;
  face.plan = solid.plan;
  const Vec2 corners[] = {{2, 0}, {40, 38}, {38, 40}, {0, 2}};
  face.outline = {loop_from_points(std::vector<Vec2>{corners[0], corners[1], corners[2]}),
                  loop_from_points(std::vector<Vec2>{corners[0], corners[2], corners[3]})};
  solid.faces = {face};
  const read::HeightMap map(solid, "rod", {});
  ASSERT_EQ(map.cells().size(), 1u);
  EXPECT_NEAR(area(map.cells()[0].area), 2 * 2 * 38 + 0, 1e-3);
  EXPECT_FALSE(contains(map.cells()[0].area, {30, 5}));
}

read::SolidFace level_face(int number, const Box& plan, double z) {
  read::SolidFace face;
  face.number = number;
  face.surface = "plane";
  face.facing = read::Facing::kUp;
  face.level = true;
  face.z_low = face.z_high = z;
  face.plan = plan;
  const Vec2 corners[] = {plan.min, {plan.max.x, plan.min.y}, plan.max, {plan.min.x, plan.max.y}};
  face.outline = {loop_from_points(corners)};
  return face;
}

TEST(HeightMap, FacesTooThinForAnAreaAreNoFloorsAndNothingIsLostBesideThem) {
  read::SolidModel solid;
  solid.plan = {{0, 0}, {40, 20}};
  solid.z_bottom = -5;
  solid.faces = {level_face(1, {{0, 0}, {10, 20}}, 0), level_face(2, {{10, 0}, {10.001, 20}}, -1),
                 level_face(3, {{10.001, 0}, {40, 20}}, -2)};
  const read::HeightMap map(solid, "edge", {});
  int floors = 0;
  for (const read::Cell& cell : map.cells()) floors += cell.floor;
  EXPECT_EQ(floors, 2);
  read::FloorSweep sweep(map, {});
  const double reach = map.reach().width() * map.reach().height();
  EXPECT_NEAR(area(sweep.free_at(-2)), reach - 200, 0.05);
  EXPECT_NEAR(area(sweep.free_at(-3)), reach - 800, 0.05);
}

TEST(StepSolid, BoxesOfBentRodsAndFreeWallsHoldThem) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const read::SolidModel solid = read::load_solid(read_file(example("handle.step")), "handle.step", {});
  Box rod, pad, wall;
  for (const read::SolidFace& face : solid.faces) {
    if (face.surface == "torus") rod = face.plan;
    if (face.surface == "free surface") wall = face.plan;
    if (face.level && std::abs(face.z_low - 3) < 1e-6)
      for (const Path& path : face.outline) pad.add(box(path));
  }
  // The ring's middle has 16 mm, its rod 4 mm.
  EXPECT_NEAR(rod.min.x, 20, 1e-5);
  EXPECT_NEAR(rod.max.x, 40, 1e-5);
  EXPECT_NEAR(rod.min.y, 18, 1e-5);
  EXPECT_NEAR(rod.max.y, 22, 1e-5);
  ASSERT_FALSE(pad.empty());
  EXPECT_LE(wall.min.x, pad.min.x + read::kCurveTolerance);
  EXPECT_GE(wall.max.x, pad.max.x - read::kCurveTolerance);
  EXPECT_GE(wall.max.y, pad.max.y - read::kCurveTolerance);
}

TEST(StepSolid, IsKnownByItsEntitiesWhereTheSchemaSaysNothing) {
  const auto text = [](const std::string& schema, const std::string& entity) {
    return "ISO-10303-21;HEADER;FILE_SCHEMA(('" + schema + "'));ENDSEC;DATA;#1=" + entity +
           ";ENDSEC;END-ISO-10303-21;";
  };
  const std::string face = "ADVANCED_FACE('',(#2),#3,.T.)";
  const std::string edition = "CONFIGURATION_CONTROL_3D_DESIGN_ED2_MIM_LF { 1 0 10303 403 1 1 4}";
  EXPECT_TRUE(read::is_step_solid(text("CONFIG_CONTROL_DESIGN", "X()")));
  EXPECT_TRUE(read::is_step_solid(text(edition, face)));
  EXPECT_TRUE(read::is_step_solid(text("OF_A_VENDOR", face)));
  EXPECT_FALSE(read::is_step_solid(text("OF_A_VENDOR", "X()")));
  EXPECT_FALSE(read::is_step_solid(text("OF_A_VENDOR", face + ";#2=WORKPLAN('',(),$,#3,$)")));
  EXPECT_FALSE(read::is_step_solid(text("MACHINING_SCHEMA", face)));
}

/// Plates of 200 x 200 mm over each other, each with a hole of the same size but for rounding, whose circle begins
/// elsewhere: flattened, the circles cross thousands of times.
read::SolidModel stack_of_plates(int plates) {
  read::SolidModel solid;
  solid.plan = {{-100, -100}, {100, 100}};
  solid.z_bottom = -plates;
  for (int i = 0; i < plates; ++i) {
    read::SolidFace face = level_face(i + 1, solid.plan, -i);
    face.outline.push_back(circle_from(0.37 * i, 60 + 1e-7 * i));
    solid.faces.push_back(std::move(face));
  }
  return solid;
}

TEST(FloorSweep, OverlaidFloorsWhoseEdgesAllButCoincideAreFound) {
  const read::SolidModel solid = stack_of_plates(40);
  const read::HeightMap map(solid, "stack", {});
  read::FloorSweep sweep(map, {});
  for (int i = 1; i <= 40; ++i) {
    const Regions free = sweep.free_at(-i);
    ASSERT_EQ(free.size(), 2u) << i;
    EXPECT_NEAR(std::min(free[0].area(), free[1].area()), circle_area(60), 0.1) << i;
  }
}

}  // namespace
}  // namespace clearcut
