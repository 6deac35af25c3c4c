// STEP solids: which side is up, which body, how far through, how much stock.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "base/random.h"
#include "base/units.h"
#include "pipeline/run.h"
#include "read/job/read_part.h"
#include "read/step_solid/orientation.h"
#include "read/step_solid/solid_model.h"
#include "support/plans.h"
#include "support/solids.h"

namespace clearcut {
namespace {

using test_support::circle_area;
using test_support::example;
using test_support::refused;
using test_support::rounded_area;
using test_support::with_tool;
using ::testing::HasSubstr;

SolidOptions turned_up(const std::string& side) {
  SolidOptions solid;
  solid.up = side;
  return solid;
}

SolidOptions turned(double degrees) {
  SolidOptions solid;
  solid.turn_deg = degrees;
  return solid;
}

SolidOptions only_body(const std::string& body) {
  SolidOptions solid;
  solid.body = body;
  return solid;
}

SolidOptions through_by(double breakthrough) {
  SolidOptions solid;
  solid.breakthrough = breakthrough;
  return solid;
}

SolidOptions with_drills(const std::vector<double>& diameters) {
  SolidOptions solid;
  solid.drills = diameters;
  return solid;
}

SolidOptions in_stock(const StockRequest& stock) {
  SolidOptions solid;
  solid.stock = stock;
  return solid;
}

Part read_solid(const std::string& name, const SolidOptions& solid) {
  ReadOptions options;
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
  // Its pocket and its hole cannot be milled from the edge, which is therefore not proposed.
  EXPECT_THAT(message, HasSubstr("as it lies no floor looks up and nothing goes through; lying flat"));
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

/// The underside of a plate with countersunk holes is the larger one, and all floors look the other way.
TEST(StepSolid, OfTwoSidesThatLeanTheOneWithFloorsIsProposed) {
  read::SolidModel solid;
  solid.bodies = {{"PLATE", 80, 60, 70}};
  solid.faces.emplace_back();
  solid.sides = {{"face16", 4743, 1, 143, 20}, {"face4", 1200, 1, 60, 80}, {"face1", 4600, 3, 37, 20}};
  try {
    read::refuse_askew(solid, "plate.step");
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("looks 37 degrees away from +Z; turn the solid with --up face1 "));
  }
  solid.faces[0].level = true;
  solid.faces[0].facing = read::Facing::kUp;
  EXPECT_NO_THROW(read::refuse_askew(solid, "plate.step"));
}

TEST(StepSolid, AnyFlatFaceCanBeTurnedUp) {
  SKIP_WITHOUT_OPEN_CASCADE();
  int pockets = 0;
  for (int face = 1; face <= 11; ++face) {
    const SolidOptions solid = turned_up("face" + std::to_string(face));
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

TEST(StepSolid, BodiesOfOneNameAreProposedByNumber) {
  read::SolidModel solid;
  solid.bodies = {{"NONE", 2, 1, 1}, {"none", 3, 1, 1}};
  try {
    read::refuse_assembly(solid, "led.step");
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("for example --body 1,"));
  }
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
  const auto floor_with = [](const SolidOptions& solid) {
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
  const StockRequest stock{{}, {}, 6, {-6, 1}};
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
  const PlanResult result = pipeline::plan_part(part, with_tool(4));
  EXPECT_TRUE(result.findings.all.clean);
}

}  // namespace
}  // namespace clearcut
