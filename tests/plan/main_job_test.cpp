// The main job: a part in, a certified program out. Every figure is taken from the program's own text, read
// back.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/error.h"
#include "base/file.h"
#include "features/tool_choice.h"
#include "pipeline/run.h"
#include "read/job/read_part.h"
#include "resolve/resolve.h"
#include "support/command.h"
#include "support/data.h"
#include "support/independent/rs274.h"
#include "support/plans.h"
#include "support/shapes.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;
using test_support::data_folder;
using test_support::expect_clean;
using test_support::with_tool;

PlanResult plan_outline(const std::string& json, double diameter) {
  const test_support::ScratchFolder folder;
  return pipeline::plan_part(read::read_part(folder.file("a.json", json), {}), with_tool(diameter));
}

std::string outline(const std::string& outer, const std::string& islands = "[]") {
  return R"({"name": "p", "units": "mm", "outer": )" + outer + R"(, "islands": )" + islands +
         R"(, "top": 0, "depth": 2})";
}

std::string regular_polygon(int sides, double across_flats) {
  std::string text;
  const double radius = across_flats / 2 / std::cos(kPi / sides);
  for (int i = 0; i < sides; ++i) {
    const Vec2 p = direction_of(2 * kPi * i / sides) * radius;
    text += (i ? ",[" : "[") + std::to_string(p.x) + "," + std::to_string(p.y) + ",0]";
  }
  return "[" + text + "]";
}

TEST(MainJob, ExactFitsArePlungedOrCutInOnePass) {
  const std::string circle = outline("[[0,5,1],[10,5,1]]"),
                    square = outline("[[0,0,0],[10,0,0],[10,10,0],[0,10,0]]");
  const std::string slot = outline("[[0,0,0],[40,0,0],[40,10,0],[0,10,0]]");
  const std::string turned = outline("[[3,-4,0],[11,2,0],[5,10,0],[-3,4,0]]");
  const std::string keyhole =
      outline("[[4.58257569495584,2,4.7912878474779195],[4.58257569495584,-2,0],[20,-2,0],[20,2,0]]");
  for (const auto& json : {circle, square, turned, keyhole}) {
    for (const std::string strategy : {"auto", "adaptive", "lom"}) {
      PlanOptions options = with_tool(10);
      options.strategy = strategy;
      const test_support::ScratchFolder folder;
      const auto result = pipeline::plan_part(read::read_part(folder.file("a.json", json), {}), options);
      expect_clean(result, strategy + " " + json);
      EXPECT_NEAR(result.findings.all.feed_mm, 3, 1e-9) << json;  // from 1 mm over the top, down 2
      EXPECT_EQ(result.findings.all.retracts, 0) << json;
    }
  }
  const auto pass = plan_outline(slot, 10);
  expect_clean(pass, slot);
  EXPECT_NEAR(pass.findings.all.feed_mm, 33, 0.01);
  // Wider than the hole by more than the rounding of a drawing: refused, never skipped.
  EXPECT_THROW(plan_outline(circle, 10.01), InputError);
}

/// A block whose whole top is faced by 2 mm, but for a boss.
Part faced_block(const Tool& tool, double allowance) {
  const auto box_loop = [](double x0, double y0, double x1, double y1) {
    const std::vector<Vec2> corners{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    return loop_from_points(corners);
  };
  Part part;
  part.name = "block";
  part.source_file = "block";
  part.stock = Stock{{{0, 0}, {100, 80}}, -20, 0};
  part.tools = {tool};
  Feature face;
  face.name = "FACE";
  face.kind = FeatureKind::kPlanarFace;
  face.floor_z = -2;
  face.target = {Region::from_valid_loops(box_loop(0, 0, 100, 80), {box_loop(40, 30, 65, 50)})};
  face.allowed = {
      Region::from_valid_loops(box_loop(-kOpenReach, -kOpenReach, 1100, 1080), {box_loop(40, 30, 65, 50)})};
  part.features = {face};
  Workingstep step;
  step.name = "face";
  step.operation.allowance_side = allowance;
  part.workplan = {step};
  return part;
}

TEST(MainJob, StockOnWallsAndRoundCornersLeaveNothingAtOpenSides) {
  for (const char* tool : {"endmill:10", "bullnose:10:corner=1.5"}) {
    for (const double allowance : {0.0, 1.0}) {
      const std::string what = std::string(tool) + " leaving " + std::to_string(allowance);
      expect_clean(pipeline::plan_part(faced_block(resolve::parse_tool(tool), allowance), {}), what);
    }
  }
}

TEST(MainJob, FishheadIsCleanInEveryWorkingstep) {
  PlanOptions options;
  options.stepdown = 2;
  const auto result = pipeline::plan_part(
      read::read_part(std::string(CLEARCUT_SOURCE_DIR) + "/examples/fishhead.p21", {}), options);
  ASSERT_EQ(result.findings.features.size(), 10u);
  for (const auto& feature : result.findings.features) {
    EXPECT_TRUE(feature.figures.clean) << feature.name;
    EXPECT_LE(feature.figures.uncut_thickness_mm, 0.01) << feature.name;
    EXPECT_LE(feature.figures.gouge_mm, 0.001) << feature.name;
  }
  expect_clean(result, "fishhead");
  // On the four faces short covers are faster than parallel lines.
  for (const auto& selection : result.selections) {
    if (selection.feature.starts_with("PLANAR_FACE")) {
      EXPECT_EQ(selection.kept(), "cover") << selection.feature;
    }
  }
  if (const auto data = data_folder())
    expect_clean(pipeline::plan_part(read::read_part(*data / "stepnc/fishhead.p21", {}), options),
                 "published fishhead");
}

TEST(MainJob, ControllersOwnInterpreterAcceptsTheProgram) {
  CLEARCUT_SKIP_WITHOUT_RS274();
  PlanOptions options;
  options.stepdown = 2;
  const auto result = pipeline::plan_part(
      read::read_part(std::string(CLEARCUT_SOURCE_DIR) + "/examples/fishhead.p21", {}), options);
  const auto canon = test_support::run_rs274(result.program);
  EXPECT_TRUE(canon.accepted) << canon.message;
  EXPECT_GT(canon.moves.size(), 100u);
}

class Shapes : public ::testing::TestWithParam<int> {};

TEST_P(Shapes, AreCleanOrRefusedByName) {
  int planned = 0;
  for (const auto& shape : test_support::all_shapes()) {
    const auto& name = shape.name;
    const auto part = test_support::part_of(shape);
    if (features::largest_fitting_diameter(part.features.at(0), {}) + Tolerances{}.fit < GetParam()) {
      EXPECT_THROW(pipeline::plan_part(part, with_tool(GetParam())), InputError) << name;
      continue;
    }
    expect_clean(pipeline::plan_part(part, with_tool(GetParam())),
                 name + " with " + std::to_string(GetParam()));
    ++planned;
  }
  EXPECT_GE(planned, 15);
}

INSTANTIATE_TEST_SUITE_P(MainJob, Shapes, ::testing::Values(4, 6, 8, 10));

TEST(MainJob, RoundPocketOf14TakesA10ButNotA16) {
  const std::string circle = outline("[[93.6,84.055,1],[79.6,84.055,1]]");
  expect_clean(plan_outline(circle, 10), "10 in 14");
  EXPECT_THROW(plan_outline(circle, 16), InputError);
}

/// What breaks other software: sizes where the cutter just fits, centres, necks.
struct Breaker {
  const char* name;
  std::string json;
  double diameter;
};

TEST(MainJob, BreakersOfOtherSoftwareAreClean) {
  const std::string square16 = outline("[[0,0,0],[16,0,0],[16,16,0],[0,16,0]]");
  const std::string square8 = outline("[[0,0,0],[8,0,0],[8,8,0],[0,8,0]]");
  const std::string slot = outline("[[0,0,0],[30,0,0],[30,2,0],[0,2,0]]");
  const std::string island =
      outline("[[0,0,0],[60,0,0],[60,40,0],[0,40,0]]", "[[[5,10,0],[30,10,0],[30,30,0],[5,30,0]]]");
  const std::string bowed = outline("[[0,0,0.05],[50,0,0],[50,30,-0.04],[0,30,0]]");
  for (const auto& breaker :
       {Breaker{"16 mm square, 6.35", square16, 6.35}, Breaker{"8 mm square, 3", square8, 3},
        Breaker{"2 mm slot, 2", slot, 2},
        Breaker{"24-gon 3.3, 3.175", outline(regular_polygon(24, 3.3)), 3.175},
        Breaker{"island 5 mm from the wall, 8", island, 8}, Breaker{"bowed sides, 6", bowed, 6}}) {
    expect_clean(plan_outline(breaker.json, breaker.diameter), breaker.name);
  }
}

}  // namespace
}  // namespace clearcut
