// STEP solids: the same regions as the drawings of the same part, set-ups, what is left out, and the whole
// job.
#include "read/step_solid/step_solid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <stdexcept>

#include "base/error.h"
#include "base/files/file.h"
#include "base/random.h"
#include "base/units.h"
#include "pipeline/run.h"
#include "post/part/stepnc_writer.h"
#include "read/read_part.h"
#include "read/step_solid/apart.h"
#include "read/step_solid/floor_sweep.h"
#include "read/step_solid/height_map.h"
#include "read/step_solid/solid_model.h"
#include "resolve/prepare.h"
#include "support/plans.h"
#include "support/same_regions.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;
using test_support::boundary_gap;
using test_support::with_tool;
using ::testing::HasSubstr;

#define SKIP_WITHOUT_OPEN_CASCADE() \
  if (!read::solids_can_be_read()) GTEST_SKIP() << "built without Open CASCADE: STEP solids cannot be read"

fs::path example(const std::string& name) {
  return fs::path(CLEARCUT_SOURCE_DIR) / "examples" / name;
}

std::string skipped(const Part& part) {
  std::string all;
  for (const Diagnostic& item : part.diagnostics.items())
    if (item.severity == Severity::kSkipped) all += item.what + "\n";
  return all;
}

double circle_area(double radius) {
  return kPi * radius * radius;
}
double rounded_area(double width, double height, double radius) {
  return width * height - (4 - kPi) * radius * radius;
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
  EXPECT_THAT(left_out, HasSubstr("the hole is cut flat at z -12"));
  EXPECT_THAT(left_out, HasSubstr("(cone, x 59..81, y 4..26, z -3..0) is neither"));
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
  const pipeline::PlanResult result =
      pipeline::plan_part(read::read_part(example(name), {}), with_tool(tool));
  ASSERT_EQ(result.findings.features.size(), result.part.features.size()) << name;
  std::size_t judged = 0;
  for (std::size_t i = 0; i < result.part.features.size(); ++i) {
    const Feature& feature = result.part.features[i];
    const auto& figures = result.findings.features[i].figures;
    EXPECT_GT(figures.feed_mm, 10) << name << ": " << feature.name;
    EXPECT_LE(figures.uncut_thickness_mm, 0.01) << name << ": " << feature.name;
    EXPECT_EQ(figures.rapid_in_material, 0) << name << ": " << feature.name;
    if (feature.kind != FeatureKind::kClosedPocket && feature.kind != FeatureKind::kRoundHole) continue;
    EXPECT_TRUE(figures.clean) << name << ": " << feature.name;
    ++judged;
  }
  EXPECT_EQ(judged, closed) << name;
  EXPECT_TRUE(result.findings.all.clean) << name;
}

TEST(StepSolid, ThePlansOfTheExamplesAreCertifiedClean) {
  SKIP_WITHOUT_OPEN_CASCADE();
  expect_clean_pockets("bracket.step", 6, 1);
  expect_clean_pockets("nested.step", 8, 3);
  expect_clean_pockets("awkward.step", 5, 3);
}

std::string refusal(const std::string& text) {
  try {
    read::read_part_text(text, "s.step", {});
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "not refused";
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

read::SolidOptions turned_up(const std::string& side) {
  read::SolidOptions solid;
  solid.up = side;
  return solid;
}
read::SolidOptions turned(double degrees) {
  read::SolidOptions solid;
  solid.turn_deg = degrees;
  return solid;
}
read::SolidOptions only_body(const std::string& body) {
  read::SolidOptions solid;
  solid.body = body;
  return solid;
}
read::SolidOptions through_by(double breakthrough) {
  read::SolidOptions solid;
  solid.breakthrough = breakthrough;
  return solid;
}
read::SolidOptions with_drills(const std::vector<double>& diameters) {
  read::SolidOptions solid;
  solid.drills = diameters;
  return solid;
}
read::SolidOptions in_stock(const read::StockRequest& stock) {
  read::SolidOptions solid;
  solid.stock = stock;
  return solid;
}

/// The message of a refusal, one line; "" where the file is read.
std::string refused(const std::string& name, const read::SolidOptions& solid) {
  read::ReadOptions options;
  options.solid = solid;
  try {
    read::read_part(example(name), options);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "";
}

Part read_solid(const std::string& name, const read::SolidOptions& solid) {
  read::ReadOptions options;
  options.solid = solid;
  return read::read_part(example(name), options);
}

std::string said(const Part& part, Severity severity) {
  std::string all;
  for (const Diagnostic& item : part.diagnostics.items())
    if (item.severity == severity) all += item.what + "\n";
  return all;
}

TEST(StepSolid, ASheetOnItsEdgeIsRefusedWithBothReadings) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const std::string message = refused("on_edge.step", {});
  EXPECT_THAT(message, HasSubstr("a sheet of 3 mm stands on its edge"));
  EXPECT_THAT(message, HasSubstr("50 mm deep out of 80 x 3 mm (--up +Z"));
  EXPECT_THAT(message, HasSubstr("3 mm deep out of 80 x 50 mm (--up +Y)"));
}

TEST(StepSolid, ASheetIsMilledFromTheSideThatIsNamed) {
  SKIP_WITHOUT_OPEN_CASCADE();
  for (const char* up : {"+Y", "-Y"}) {
    const Part part = read_solid("on_edge.step", turned_up(up));
    ASSERT_TRUE(part.stock);
    EXPECT_NEAR(part.stock->z_top - part.stock->z_bottom, 3, 1e-9);
    EXPECT_NEAR(part.stock->plan.width(), 80, 1e-9);
    EXPECT_NEAR(part.stock->plan.height(), 50, 1e-9);
    EXPECT_EQ(part.features.size(), up[0] == '+' ? 2u : 1u);
    EXPECT_EQ(part.features.back().kind, FeatureKind::kRoundHole);
    EXPECT_NEAR(part.features.back().hole_diameter.value_or(0), 12, 1e-9);
  }
  const Part pocket = read_solid("on_edge.step", turned_up("+Y"));
  EXPECT_EQ(pocket.features[0].kind, FeatureKind::kClosedPocket);
  EXPECT_NEAR(area(pocket.features[0].target), 900, 1e-6);
  EXPECT_NEAR(pocket.features[0].top_z - pocket.features[0].floor_z, 1, 1e-9);
}

/// What was meant so is done so.
TEST(StepSolid, ASheetStaysOnItsEdgeWhenThatIsSaid) {
  SKIP_WITHOUT_OPEN_CASCADE();
  EXPECT_THAT(refused("on_edge.step", turned_up("+Z")), HasSubstr("turn the solid with --up +Y"));
}

TEST(StepSolid, WithoutAFloorTheSideToTurnUpIsNamed) {
  SKIP_WITHOUT_OPEN_CASCADE();
  EXPECT_THAT(refused("sideways.step", {}), HasSubstr("turn the solid with --up -X"));
  const Part part = read_solid("sideways.step", turned_up("-X"));
  ASSERT_EQ(part.features.size(), 1u);
  EXPECT_NEAR(area(part.features[0].target), 14 * 20, 1e-6);
  EXPECT_NEAR(part.features[0].top_z - part.features[0].floor_z, 6, 1e-9);
}

TEST(StepSolid, AnyFlatFaceCanBeTurnedUp) {
  SKIP_WITHOUT_OPEN_CASCADE();
  int pockets = 0;
  for (int face = 1; face <= 11; ++face) {
    const read::SolidOptions solid = turned_up("face" + std::to_string(face));
    if (!refused("sideways.step", solid).empty()) continue;
    for (const Feature& feature : read_solid("sideways.step", solid).features)
      pockets += std::abs(area(feature.target) - 280) < 1e-6 ? 1 : 0;
  }
  EXPECT_EQ(pockets, 2) << "the face around the pocket, and its floor";
  EXPECT_THAT(refused("sideways.step", turned_up("face12")), HasSubstr("has no such face"));
  EXPECT_THAT(refused("disc.step", turned_up("face1")) + refused("disc.step", turned_up("face2")) +
                  refused("disc.step", turned_up("face3")),
              HasSubstr("this face is not flat"));
  EXPECT_THAT(refused("disc.step", turned_up("X")), HasSubstr("use +Z, -Z"));
}

TEST(StepSolid, TurnsAboutTheVerticalAreExactForQuarters) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const Part part = read_solid("bracket.step", turned(90));
  ASSERT_TRUE(part.stock);
  EXPECT_EQ(part.stock->plan.min, (Vec2{-60, -10}));
  EXPECT_EQ(part.stock->plan.max, (Vec2{10, 90}));
  const Part straight = read_solid("bracket.step", {});
  EXPECT_NEAR(area(part.features[0].target), area(straight.features[0].target), 1e-6);
  const Part slanted = read_solid("bracket.step", turned(30));
  EXPECT_EQ(slanted.features[0].kind, FeatureKind::kClosedPocket);
  EXPECT_NEAR(area(slanted.features[0].target), area(straight.features[0].target), 1e-6);
}

TEST(StepSolid, AssembliesAreRefusedWithTheNamesOfTheirBodies) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const std::string message = refused("plate_and_pins.step", {});
  EXPECT_THAT(message, HasSubstr("an assembly of 3 bodies"));
  EXPECT_THAT(message, HasSubstr("--body \"PLATE\""));
  EXPECT_THAT(message, HasSubstr("1 'PLATE' (60 x 40 x 10); 2, 3 'PIN' (6 x 6 x 12)"));
  EXPECT_THAT(refused("plate_and_pins.step", only_body("LID")), HasSubstr("none of that name or number"));
  EXPECT_THAT(refused("plate_and_pins.step", only_body("PIN")), HasSubstr("give the number"));
}

TEST(StepSolid, OneBodyOfAnAssemblyIsChosenByNameOrNumber) {
  SKIP_WITHOUT_OPEN_CASCADE();
  for (const char* body : {"PLATE", "plate", "1"}) {
    const Part part = read_solid("plate_and_pins.step", only_body(body));
    ASSERT_EQ(part.features.size(), 1u) << body;
    EXPECT_NEAR(area(part.features[0].target), rounded_area(30, 20, 4), 1e-6) << body;
    EXPECT_NEAR(part.stock->z_top, 0, 1e-9) << body;
  }
  const Part all = read_solid("plate_and_pins.step", only_body("all"));
  EXPECT_NEAR(all.stock->z_top, 12, 1e-9);
  EXPECT_THAT(said(all, Severity::kWarning), HasSubstr("3 solids are taken as one part"));
}

TEST(StepSolid, WhatGoesThroughGoesBelowTheSolid) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const auto floor_with = [](const read::SolidOptions& solid) {
    return read_solid("nested.step", solid).features.back().floor_z;
  };
  EXPECT_NEAR(floor_with({}), -20.5, 1e-9);
  EXPECT_NEAR(floor_with(through_by(0)), -20, 1e-9);
  EXPECT_NEAR(floor_with(through_by(2)), -22, 1e-9);
  EXPECT_NEAR(floor_with(with_drills({8, 12})), -20.5 - 0.3004 * 12, 1e-9);
  EXPECT_THAT(said(read_solid("nested.step", {}), Severity::kWarning),
              HasSubstr("1 cut(s) go through, 0.5 mm below"));
}

TEST(StepSolid, AMarginAroundTheSolidIsMilledAway) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const read::StockRequest stock{{}, {}, 6, {-6, 1}};
  const Part part = read_solid("disc.step", in_stock(stock));
  ASSERT_TRUE(part.stock);
  EXPECT_NEAR(part.stock->plan.min.x, -36, 1e-6);
  EXPECT_NEAR(part.stock->z_top, 1, 1e-9);
  ASSERT_EQ(part.features.size(), 3u);
  EXPECT_EQ(part.features[0].kind, FeatureKind::kPlanarFace);
  EXPECT_NEAR(part.features[0].floor_z, 0, 1e-9);
  EXPECT_NEAR(area(part.features[0].target), 72 * 72, 1e-6);
  const Feature* outside = nullptr;
  for (const Feature& feature : part.features)
    if (feature.kind == FeatureKind::kOutsideProfile) outside = &feature;
  ASSERT_TRUE(outside);
  EXPECT_NEAR(area(outside->target), 72 * 72 - circle_area(30), 1e-3);
  EXPECT_NEAR(outside->top_z, 0, 1e-9);
  EXPECT_NEAR(outside->floor_z, -6.5, 1e-9);
  EXPECT_THAT(said(part, Severity::kWarning), HasSubstr("the part comes loose"));
  EXPECT_THAT(refused("disc.step", in_stock({{}, {}, 6, {-5, 0}})),
              HasSubstr("the stock does not hold the solid"));
}

TEST(StepSolid, TheMarginOfAJobIsMilledAway) {
  SKIP_WITHOUT_OPEN_CASCADE();
  const std::string job = "[part]\nfile = \"disc.step\"\n[stock]\nmargin = 6\nz = [-6, 0]\n";
  const Part part = read::read_part_text(job, example("margin.toml").string(), {});
  ASSERT_TRUE(part.stock);
  EXPECT_NEAR(part.stock->plan.max.x, 36, 1e-6);
  EXPECT_NEAR(area(part.features.back().target) + area(part.features.front().target),
              72 * 72 - circle_area(30) + circle_area(3), 1e-3);
  const pipeline::PlanResult result = pipeline::plan_part(part, with_tool(4));
  EXPECT_TRUE(result.findings.all.clean);
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

/// Plates of 200 x 200 mm over each other, each with a hole of the same size but for rounding, whose circle begins
/// elsewhere: flattened, the circles cross thousands of times.
read::SolidModel stack_of_plates(int plates) {
  read::SolidModel solid;
  solid.plan = {{-100, -100}, {100, 100}};
  solid.z_bottom = -plates;
  for (int i = 0; i < plates; ++i) {
    read::SolidFace face;
    face.number = i + 1;
    face.surface = "plane";
    face.facing = read::Facing::kUp;
    face.level = true;
    face.z_low = face.z_high = -i;
    face.plan = solid.plan;
    const Vec2 corners[] = {{-100, -100}, {100, -100}, {100, 100}, {-100, 100}};
    face.outline = {loop_from_points(corners), circle_from(0.37 * i, 60 + 1e-7 * i)};
    solid.faces.push_back(std::move(face));
  }
  return solid;
}

TEST(FloorSweep, OverlaidFloorsWhoseEdgesAllButCoincideAreFast) {
  const read::SolidModel solid = stack_of_plates(40);
  const read::HeightMap map(solid, "stack", {});
  read::FloorSweep sweep(map, {});
  const std::clock_t begin = std::clock();
  for (int i = 1; i <= 40; ++i) {
    const Regions free = sweep.free_at(-i);
    ASSERT_EQ(free.size(), 2u) << i;
    EXPECT_NEAR(std::min(free[0].area(), free[1].area()), circle_area(60), 0.1) << i;
  }
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 2) << "s of the processor";
}

TEST(DoneApart, HandsOverMoreThanAPipeHolds) {
  const std::string long_text(1 << 20, 'x');
  EXPECT_EQ(read::done_apart({"/bin/cat"}, long_text, 10), long_text);
}

TEST(DoneApart, CrashesErrorsAndEndlessWorkAreNothing) {
  EXPECT_EQ(read::done_apart({"/bin/sh", "-c", "echo half; kill -SEGV $$"}, "", 10), std::nullopt);
  EXPECT_EQ(read::done_apart({"/bin/sh", "-c", "echo half; exit 3"}, "", 10), std::nullopt);
  EXPECT_EQ(read::done_apart({"/bin/sh", "-c", "while :; do :; done"}, "", 1), std::nullopt);
  EXPECT_EQ(read::done_apart({"/nonexistent/program"}, "", 10), std::nullopt);
}

}  // namespace
}  // namespace clearcut
