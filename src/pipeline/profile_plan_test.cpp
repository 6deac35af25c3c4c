// Drawings with roles through the whole way: read, planned, certified, and what wrong programs are called.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/random.h"
#include "base/units.h"
#include "pipeline/check.h"
#include "pipeline/run.h"
#include "read/job/read_part.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

std::string rectangle(const std::string& layer, double x0, double y0, double x1, double y1) {
  const auto point = [](double x, double y) {
    return "10\n" + std::to_string(x) + "\n20\n" + std::to_string(y) + "\n";
  };
  return "0\nLWPOLYLINE\n8\n" + layer + "\n90\n4\n70\n1\n" + point(x0, y0) + point(x1, y0) + point(x1, y1) +
         point(x0, y1);
}

std::string circle(const std::string& layer, double x, double y, double r) {
  return "0\nCIRCLE\n8\n" + layer + "\n10\n" + std::to_string(x) + "\n20\n" + std::to_string(y) + "\n40\n" +
         std::to_string(r) + "\n";
}

std::string line(const std::string& layer, double x0, double y0, double x1, double y1) {
  return "0\nLINE\n8\n" + layer + "\n10\n" + std::to_string(x0) + "\n20\n" + std::to_string(y0) + "\n11\n" +
         std::to_string(x1) + "\n21\n" + std::to_string(y1) + "\n";
}

std::string dxf(const std::string& entities) {
  return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities +
         "0\nENDSEC\n0\nEOF\n";
}

/// A plate of 80 x 50 mm with a pocket and two holes.
std::string plate(const std::string& edge, const std::string& pocket, const std::string& holes) {
  return dxf(rectangle(edge, 0, 0, 80, 50) + rectangle(pocket, 20, 15, 60, 35) + circle(holes, 8, 8, 3) +
             circle(holes, 72, 42, 3));
}

ReadOptions asking(double depth = 0) {
  ReadOptions options;
  options.ask_if_unclear = true;
  if (depth > 0) options.depth = depth;
  return options;
}

PlanOptions with_mill(const std::string& tool, int tabs = 0) {
  PlanOptions options;
  options.tools = {resolve::parse_tool(tool)};
  options.strategy = "contour";
  options.tabs.count = tabs;
  return options;
}

std::string faults_of(const Findings& findings) {
  std::string text;
  for (const Fault& fault : findings.faults)
    text += std::string(name_of(fault.kind)) + ": " + fault.text + "\n";
  return text;
}

bool has(const Findings& findings, FaultKind kind) {
  return std::any_of(findings.faults.begin(), findings.faults.end(),
                     [&](const Fault& fault) { return fault.kind == kind; });
}

std::string refusal(const std::string& text, const ReadOptions& options) {
  try {
    read::read_part_text(text, "plate.dxf", options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

LayerRule asked(LayerRole role, const std::string& pattern) {
  LayerRule rule;
  rule.role = role;
  rule.pattern = pattern;
  rule.asked = true;
  return rule;
}

TEST(DrawingRoles, NamesOfLayersSayWhatOutlinesAreFor) {
  const Part part = read::read_part_text(plate("PROFILE_D6", "POCKET_D3", "DRILL_D6"), "plate.dxf", asking());
  ASSERT_EQ(part.features.size(), 4u);
  EXPECT_EQ(part.features[0].kind, FeatureKind::kClosedPocket);
  EXPECT_EQ(part.features[1].kind, FeatureKind::kRoundHole);
  EXPECT_EQ(part.features[3].kind, FeatureKind::kOutsideProfile);
  EXPECT_EQ(part.features[3].floor_z, -6);
}

TEST(DrawingRoles, SeveralOuterOutlinesThatAllHoldOthersAreAskedAbout) {
  const auto two = [](const std::string& more) {
    return dxf(rectangle("0", 0, 0, 80, 50) + circle("0", 20, 20, 3) + rectangle("0", 100, 0, 180, 50) +
               circle("0", 120, 20, 3) + more);
  };
  const std::string question = refusal(two(""), asking(6));
  EXPECT_THAT(question, HasSubstr("holds 1 other, as each of 2 outermost outlines does"));
  EXPECT_THAT(question, HasSubstr("--op profile:outer"));
  auto options = asking(6);
  options.layer_rules = {asked(LayerRole::kProfile, "outer")};
  EXPECT_EQ(read::read_part_text(two(""), "plate.dxf", options).features.size(), 4u);
  // One that stands alone among them takes the question not away.
  EXPECT_THAT(refusal(two(rectangle("0", 200, 0, 220, 20)), asking(6)),
              HasSubstr("as 2 of 3 outermost outlines do"));
}

/// Plates of a sheet without holes would be milled to chips as pockets.
TEST(DrawingRoles, PlainOutlinesBesideEachOtherAreAskedAbout) {
  const std::string plates = rectangle("0", 0, 0, 80, 50) + rectangle("CUT", 100, 0, 180, 50);
  const std::string question = refusal(dxf(plates), asking(6));
  EXPECT_THAT(question, HasSubstr("2 outlines beside each other, the first of 80 x 50 mm (layer 0)"));
  EXPECT_THAT(question, HasSubstr("--op profile:outer"));
  EXPECT_THAT(question, HasSubstr("--op pocket:outer"));
  EXPECT_THAT(refusal(dxf(circle("0", 0, 0, 15) + circle("0", 40, 0, 15)), asking(6)),
              HasSubstr("2 outlines beside each other"));
  for (const auto& [role, kind] : {std::pair{LayerRole::kProfile, FeatureKind::kOutsideProfile},
                                   {LayerRole::kPocket, FeatureKind::kClosedPocket}}) {
    auto options = asking(6);
    options.layer_rules = {asked(role, "outer")};
    const Part part = read::read_part_text(dxf(plates), "plate.dxf", options);
    ASSERT_EQ(part.features.size(), 2u);
    for (const Feature& feature : part.features) EXPECT_EQ(feature.kind, kind);
  }
  // Of holes, of one outline, and of what layers say there is no question.
  const std::string holes = circle("0", 0, 0, 3) + circle("0", 40, 0, 6.5);
  for (const std::string& clear : {holes, holes + rectangle("0", 0, 50, 80, 80), rectangle("0", 0, 0, 80, 50),
                                   rectangle("POCKET_D6", 0, 0, 80, 50) + rectangle("0", 100, 0, 180, 50),
                                   rectangle("D3", 0, 0, 80, 50) + rectangle("D3", 100, 0, 180, 50),
                                   rectangle("STOCK_D12", -10, -10, 200, 80) + rectangle("0", 0, 0, 80, 50) +
                                       rectangle("0", 100, 0, 180, 50)})
    EXPECT_GT(read::read_part_text(dxf(clear), "plate.dxf", asking(6)).features.size(), 0u);
}

/// What the question promises: islands stand, whatever layer they are drawn on.
TEST(DrawingRoles, IslandsOfAnOuterPocketMayLieOnOtherLayers) {
  const std::string text =
      dxf(rectangle("A", 0, 0, 80, 50) + circle("B", 20, 20, 8) + circle("B", 60, 20, 8) +
          circle("C", 60, 20, 3) + rectangle("A", 100, 0, 180, 50) +
          rectangle("POCKET_D1", 110, 10, 120, 20) + rectangle("D1", 130, 10, 140, 20));
  auto options = asking(6);
  options.ask_if_unclear = false;  // shallow pockets in deeper ones are asked about
  options.depth.reset();
  options.depth_if_missing = 6;
  options.layer_rules = {asked(LayerRole::kPocket, "outer")};
  const Part part = read::read_part_text(text, "plate.dxf", options);
  const double island = 80 * 50 - kPi * 128, whole = 80 * 50;
  ASSERT_EQ(part.features.size(), 5u);
  std::vector<double> areas;
  for (const Feature& feature : part.features) areas.push_back(area(feature.target));
  EXPECT_THAT(areas, ::testing::UnorderedElementsAre(
                         ::testing::DoubleNear(island, 1e-6), ::testing::DoubleNear(kPi * 9, 1e-6),
                         ::testing::DoubleNear(whole, 1e-6), ::testing::DoubleNear(100, 1e-6),
                         ::testing::DoubleNear(100, 1e-6)));
  // A depth that the option says counts, for all of it.
  options.layer_rules.front().depth = 3;
  for (const Feature& feature : read::read_part_text(text, "plate.dxf", options).features)
    EXPECT_EQ(feature.floor_z, area(feature.target) > 100.5 || area(feature.target) < 99 ? -3 : -1);
}

TEST(DrawingRoles, AnOutlineInAPocketOfAnotherLayerIsAskedAbout) {
  const std::string text =
      dxf(rectangle("A", 0, 0, 80, 50) + circle("B", 20, 20, 8) + rectangle("C", 100, 0, 120, 20));
  // The outermost outline is said to be a pocket, so that it is no question any more.
  const auto without = [](const std::string& number) {
    auto options = asking(6);
    options.layer_rules = {asked(LayerRole::kPocket, "A"), asked(LayerRole::kIgnore, number)};
    return options;
  };
  const std::string question = refusal(text, without("3"));
  EXPECT_THAT(question, HasSubstr("layer B: the outline of 16 x 16 mm at (12, 12) lies in a pocket"));
  EXPECT_THAT(question, HasSubstr("--op island:B"));
  EXPECT_THAT(question, Not(HasSubstr("the same has to be said")));
  const std::string more =
      dxf(rectangle("A", 0, 0, 80, 50) + circle("B", 20, 20, 8) + circle("D", 20, 20, 3) +
          circle("E", 60, 20, 8) + rectangle("C", 100, 0, 120, 20));
  EXPECT_THAT(refusal(more, without("5")), HasSubstr("; the same has to be said of D (in A), E (in A)"));
  DrawingOverview overview;
  auto looking = without("3");
  looking.overview = &overview;
  read::read_part_text(text, "plate.dxf", looking);
  EXPECT_THAT(overview.question, HasSubstr("--op island:B"));
  auto options = asking(6);
  options.layer_rules = {asked(LayerRole::kIsland, "B")};
  EXPECT_NEAR(area(read::read_part_text(text, "plate.dxf", options).features[0].target), 4000 - 64 * kPi,
              1e-6);
  options.layer_rules = {asked(LayerRole::kPocket, "A"), asked(LayerRole::kPocket, "B"),
                         asked(LayerRole::kIgnore, "3")};
  EXPECT_NEAR(area(read::read_part_text(text, "plate.dxf", options).features[0].target), 4000, 1e-6);
  // The same outline on two layers is one.
  EXPECT_EQ(refusal(dxf(rectangle("A", 0, 0, 80, 50) + rectangle("B", 0, 0, 80, 50)), asking(6)), "");
}

TEST(DrawingRoles, AnOuterOutlineThatHoldsOthersIsAskedAbout) {
  const std::string text = plate("0", "0", "0");
  const std::string question = refusal(text, asking(6));
  EXPECT_THAT(question, HasSubstr("80 x 50 mm (layer 0) holds 3 others"));
  EXPECT_THAT(question, HasSubstr("--op profile:outer"));
  EXPECT_THAT(question, HasSubstr("--op pocket:outer"));
  auto options = asking(6);
  options.layer_rules = {asked(LayerRole::kPocket, "outer")};
  EXPECT_EQ(read::read_part_text(text, "plate.dxf", options).features.size(), 1u);
  options.layer_rules = {asked(LayerRole::kProfile, "outer")};
  EXPECT_EQ(read::read_part_text(text, "plate.dxf", options).features.size(), 4u);
  options.layer_rules = {asked(LayerRole::kProfile, "NO_SUCH")};
  EXPECT_THAT(refusal(text, options), HasSubstr("no layer or outline is called 'NO_SUCH'"));
  // The layer of the edge alone says nothing, too.
  EXPECT_THAT(refusal(plate("0", "POCKET_D3", "DRILL_D6"), asking(6)), HasSubstr("holds 3 others"));
  // One outline alone is a pocket as ever.
  EXPECT_EQ(refusal(dxf(rectangle("0", 0, 0, 80, 50)), asking(6)), "");
}

TEST(DrawingRoles, ProfilesNestAcrossLayers) {
  const Part part =
      read::read_part_text(plate("PERIMETER_D6", "CUTOUTS_D6", "CUTOUTS_D6"), "plate.dxf", asking());
  ASSERT_EQ(part.features.size(), 4u);
  EXPECT_EQ(part.features[0].kind, FeatureKind::kInsideProfile);
  EXPECT_EQ(part.features[2].kind, FeatureKind::kInsideProfile);
  EXPECT_EQ(part.features[3].kind, FeatureKind::kOutsideProfile);
}

TEST(DrawingRoles, OverlappingLayersOfOneDepthAreMilledOnce) {
  const std::string text =
      dxf(rectangle("INNER_D3", 10, 10, 30, 30) + rectangle("AREA_POCKET_D3", 0, 0, 40, 40));
  EXPECT_EQ(read::read_part_text(text, "plate.dxf", asking()).features.size(), 1u);
  const std::string crossing = dxf(rectangle("A_D3", 0, 0, 20, 20) + rectangle("B_D3", 10, 0, 30, 20));
  const Part part = read::read_part_text(crossing, "plate.dxf", asking());
  // There is no wall between them: the cutter goes from one into the other.
  ASSERT_EQ(part.features.size(), 1u);
  EXPECT_NEAR(area(part.features[0].target), 600, 0.1);
  EXPECT_TRUE(plan_part(part, with_mill("endmill:4")).findings.all.clean);
}

TEST(DrawingRoles, OutlinesAtTheEdgeOfTheStockAreOpenThere) {
  const std::string frame =
      R"({"units": "mm", "stock": {"x": [0, 60], "y": [0, 40], "z": [-2, 0]}, "pockets": [{"kind": "outside_profile",
          "depth": 2, "through": true, "outer": [[0, 0], [60, 0], [60, 40], [0, 40]],
          "islands": [[[4, 4], [4, 36], [56, 36], [56, 4]]]}]})";
  // The cutter may leave the block: its corners are no corners of a wall.
  for (const char* strategy : {"contour", "zigzag", "spiral", "adaptive"}) {
    PlanOptions options = with_mill("endmill:2");
    options.strategy = strategy;
    const auto result = plan_part(read::read_part_text(frame, "frame.json", {}), options);
    EXPECT_TRUE(result.findings.all.clean) << strategy;
    EXPECT_LT(result.findings.all.unreachable_mm2, 0.1) << strategy;
  }
  const Part drawn =
      read::read_part_text(dxf(rectangle("STOCK", 0, 0, 60, 40) + rectangle("POCKET_D2", 20, 10, 60, 30) +
                               rectangle("POCKET_D2", 5, 5, 15, 35)),
                           "drawn.dxf", {});
  ASSERT_EQ(drawn.features.size(), 2u);
  EXPECT_EQ(drawn.features[0].kind == FeatureKind::kOpenPocket, area(drawn.features[0].target) > 500);
  EXPECT_EQ(drawn.features[1].kind == FeatureKind::kOpenPocket, area(drawn.features[1].target) > 500);
}

TEST(DrawingRoles, NumbersChooseOutlines) {
  auto options = asking(6);
  DrawingOverview overview;
  options.overview = &overview;
  read::read_part_text(plate("0", "0", "0"), "plate.dxf", options);
  ASSERT_EQ(overview.outlines.size(), 4u);
  EXPECT_EQ(overview.outlines[0].number, 1);
  EXPECT_THAT(overview.question, HasSubstr("--op profile:outer"));
  options.overview = nullptr;
  options.layer_rules = {asked(LayerRole::kProfile, "1"), asked(LayerRole::kInside, "2")};
  const Part part = read::read_part_text(plate("0", "0", "0"), "plate.dxf", options);
  EXPECT_EQ(part.features.back().kind, FeatureKind::kOutsideProfile);
  EXPECT_EQ(part.features[part.features.size() - 2].kind, FeatureKind::kInsideProfile);
  options.layer_rules = {asked(LayerRole::kProfile, "9")};
  EXPECT_THAT(refusal(plate("0", "0", "0"), options), HasSubstr("there is no outline 9"));
}

/// The overview asks where a plan refuses, and what is proposed is enough.
TEST(DrawingRoles, OpenLinesAloneMayBeFollowed) {
  const std::string open = dxf(line("0", 0, 0, 45, 15) + line("0", 0, 15, 45, 0));
  EXPECT_THAT(refusal(open, asking(6)), HasSubstr("--op engrave:'*'"));
  auto options = asking(6);
  options.depth.reset();
  DrawingOverview overview;
  options.overview = &overview;
  read::read_part_text(open, "plate.dxf", options);
  EXPECT_THAT(overview.question, HasSubstr("--op engrave:'*'"));
  overview = {};
  options.layer_rules = {asked(LayerRole::kEngrave, "*")};
  read::read_part_text(open, "plate.dxf", options);
  EXPECT_EQ(overview.lines, 2);
  EXPECT_FALSE(overview.lines_have_depths);
  EXPECT_EQ(overview.question, "");
  options.depth = 0.3;
  overview = {};
  read::read_part_text(open, "plate.dxf", options);
  EXPECT_TRUE(overview.lines_have_depths);
  options.overview = nullptr;
  EXPECT_EQ(read::read_part_text(open, "plate.dxf", options).features.size(), 2u);
}

/// What lies beyond the stock is not asked for; where a line crosses its side at an angle places beside the kerf counted as left.
TEST(Profiles, LinesThatLeaveTheStockAtAnAngleAreEngravedClean) {
  for (const double y : {18.377777, 25.3, 38.377777}) {
    const std::string text =
        dxf(rectangle("STOCK_D20", 0, 0, 100, 60) + line("ENGRAVE_D5", -12.3333, y, 60, 33.712345));
    const auto result = plan_part(read::read_part_text(text, "plate.dxf", asking()), with_mill("endmill:6"));
    EXPECT_TRUE(result.findings.all.clean) << y << faults_of(result.findings);
  }
}

TEST(DrawingRoles, OddSizesAndOpenLinesAreQuestioned) {
  EXPECT_THAT(refusal(dxf(rectangle("0", 0, 0, 3700, 2000)), asking(6)), HasSubstr("larger than 2 m"));
  EXPECT_THAT(refusal(dxf(rectangle("0", 0, 0, 0.5, 0.4)), asking(0.1)), HasSubstr("smaller than 1 mm"));
  const std::string open = dxf(rectangle("POCKET", 0, 0, 40, 30) + line("CENTRE", -5, 15, 45, 15));
  EXPECT_THAT(refusal(open, asking(6)), HasSubstr("--open-curves skip"));
  auto options = asking(6);
  options.open_curves = OpenCurves::kSkip;
  EXPECT_EQ(read::read_part_text(open, "plate.dxf", options).features.size(), 1u);
}

TEST(Profiles, APlateIsCutOutLast) {
  const Part part =
      read::read_part_text(plate("PROFILE_D6", "POCKET_D3", "INSIDE_D6"), "plate.dxf", asking());
  const auto result = plan_part(part, with_mill("endmill:4"));
  EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings);
  EXPECT_EQ(result.toolpath.sections.size(), 4u);
  const Section& last = result.toolpath.sections.back();
  for (const Move& move : last.moves) {
    if (is_rapid(move.kind) || move.z_to >= 0) continue;
    // Outside the plate by the cutter's radius all along.
    const Box plate_box{{0, 0}, {80, 50}};
    EXPECT_NEAR(plate_box.distance_to(move.path.at(0.5)), 2, 0.003);
  }
}

TEST(Profiles, InsideAndOnTheLine) {
  const Part part =
      read::read_part_text(dxf(rectangle("INSIDE_D4", 0, 0, 60, 40) + line("ENGRAVE_D0.5", 70, 0, 90, 30) +
                               line("ENGRAVE_D0.5", 90, 30, 110, 0) + circle("ENGRAVE_D0.5", 130, 20, 8)),
                           "sign.dxf", asking());
  const auto result = plan_part(part, with_mill("endmill:3"));
  EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings);
}

TEST(Profiles, TwoPartsOfOneSheetLeaveEachOtherAlone) {
  const Part part = read::read_part_text(
      dxf(rectangle("PROFILE_D4", 0, 0, 40, 30) + rectangle("PROFILE_D4", 47, 0, 87, 30)), "two.dxf",
      asking());
  const auto result = plan_part(part, with_mill("endmill:6"));
  EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings);
}

TEST(Tabs, StandAtTheirPlacesAndHeights) {
  const Part part = read::read_part_text(plate("PROFILE_D6", "POCKET_D3", "DRILL_D6"), "plate.dxf", asking());
  const auto result = plan_part(part, with_mill("endmill:4", 4));
  EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings);
  const auto found = std::find_if(result.part.features.begin(), result.part.features.end(),
                                  [](const Feature& f) { return f.profile && !f.profile->tabs.empty(); });
  ASSERT_NE(found, result.part.features.end());
  EXPECT_EQ(found->profile->tabs.size(), 4u);
  for (const Tab& tab : found->profile->tabs) EXPECT_NEAR(tab.top_z, -4, 1e-9);
}

/// In an acute corner the kerfs of both sides run into each other: a tab of one would be cut by the other.
TEST(Tabs, AreNotPlacedWhereTheKerfOfAnotherSideComes) {
  const std::string kite =
      "0\nLWPOLYLINE\n8\nINSIDE_D4\n90\n4\n70\n1\n10\n21.736\n20\n4.934\n10\n-4.683\n20\n8.467\n10\n-22.621\n"
      "20\n2.13\n10\n9.985\n20\n-8.94\n";
  const auto result =
      plan_part(read::read_part_text(dxf(kite), "kite.dxf", asking()), with_mill("endmill:2", 6));
  EXPECT_EQ(faults_of(result.findings), "");
  for (const Feature& feature : result.part.features) {
    if (!feature.profile) continue;
    for (const Tab& tab : feature.profile->tabs) EXPECT_GT(tab.center.x, -14);
  }
}

TEST(Tabs, WrongProgramsAreFaultyByName) {
  const Part part = read::read_part_text(dxf(rectangle("PROFILE_D6", 0, 0, 80, 50)), "plate.dxf", asking());
  const std::string without = plan_part(part, with_mill("endmill:4")).program;
  EXPECT_TRUE(has(check_program(part, without, "without.ngc", with_mill("endmill:4", 4)).findings,
                  FaultKind::kMissingTab));
  auto low = with_mill("endmill:4", 4), high = with_mill("endmill:4", 4);
  low.tabs.height = 1.5;
  high.tabs.height = 2.5;
  const std::string right = plan_part(part, with_mill("endmill:4", 4)).program;
  EXPECT_TRUE(check_program(part, right, "right.ngc", with_mill("endmill:4", 4)).findings.all.clean);
  for (const auto& other : {low, high}) {
    const auto findings = check_program(part, right, "right.ngc", other).findings;
    EXPECT_TRUE(has(findings, FaultKind::kTabHeight)) << faults_of(findings);
  }
}

/// A star of `count` corners about (0, 0), if `bulging` with arcs among its sides.
std::string star(const std::string& layer, int count, bool bulging, Random& random) {
  std::string text = "0\nLWPOLYLINE\n8\n" + layer + "\n90\n" + std::to_string(count) + "\n70\n1\n";
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / count, radius = random.between(25, 45);
    text += "10\n" + std::to_string(radius * std::cos(angle)) + "\n20\n" +
            std::to_string(radius * std::sin(angle)) + "\n";
    if (bulging && random.unit() < 0.3) text += "42\n" + std::to_string(random.between(-0.15, 0.15)) + "\n";
  }
  return text;
}

/// Right: the program is clean, whatever the outline, side and cutter; with tabs outside where all sides are straight. Cannot see: whether the kerf is the right one,
/// which the plate above shows.
TEST(Profiles, RandomOutlinesAreClean) {
  Random random(7);
  int held = 0;
  for (int i = 0; i < 40; ++i) {
    const bool inside = i % 3 == 0;
    const std::string text = dxf(star(inside ? "INSIDE_D4" : "PROFILE_D4", 5 + i % 12, i % 4 == 0, random));
    const Part part = read::read_part_text(text, "star.dxf", asking());
    auto options = with_mill("endmill:" + std::to_string(1 + i % 6), inside ? 0 : i % 4);
    options.tabs.width = 2;
    try {
      const auto result = plan_part(part, options);
      EXPECT_TRUE(result.findings.all.clean) << i << ": " << faults_of(result.findings);
      held += options.tabs.count > 0 ? 1 : 0;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("tabs of 2 mm fit")) << i;
    }
  }
  EXPECT_GT(held, 10);
}

TEST(Skin, HoldsWhatAProfileSurrounds) {
  const Part part = read::read_part_text(dxf(rectangle("PROFILE_D6", 0, 0, 60, 40)), "plate.dxf", asking());
  auto options = with_mill("endmill:4", 0);
  options.tabs.skin = 0.4;
  const auto result = plan_part(part, options);
  EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings);
  double lowest = 0;
  for (const Section& section : result.toolpath.sections)
    for (const Move& move : section.moves) lowest = std::min({lowest, move.z_from, move.z_to});
  EXPECT_NEAR(lowest, -5.6, 1e-9);
  // A program that goes through it is wrong.
  const auto through = plan_part(part, with_mill("endmill:4", 0));
  EXPECT_FALSE(check_program(part, through.program, "through.ngc", options).findings.all.clean);
  options.tabs.skin = 6;
  EXPECT_THROW(plan_part(part, options), InputError);
  options.tabs.skin = 0.4;
  options.tabs.count = 2;
  EXPECT_THROW(resolve::check(options), InputError);
}

TEST(Tabs, AreRefusedWhereTheyDoNotFit) {
  const Part part = read::read_part_text(dxf(rectangle("PROFILE_D6", 0, 0, 8, 8)), "small.dxf", asking());
  EXPECT_THROW(plan_part(part, with_mill("endmill:4", 4)), InputError);
}

int tabs_in(const Part& part) {
  int count = 0;
  for (const Feature& feature : part.features)
    if (feature.profile) count += static_cast<int>(feature.profile->tabs.size());
  return count;
}

TEST(Tabs, StandWhereNoNeighboursKerfPasses) {
  for (const double gap : {0.5, 1.0, 1.9, 2.0, 2.5, 3.5}) {
    const std::string two =
        dxf(rectangle("PROFILE_D3", 0, 0, 40, 30) + rectangle("PROFILE_D3", 40 + gap, 0, 80 + gap, 30));
    const auto result = plan_part(read::read_part_text(two, "two.dxf", asking()), with_mill("endmill:2", 3));
    EXPECT_EQ(faults_of(result.findings), "") << gap;
    EXPECT_EQ(tabs_in(result.part), 6) << gap;
  }
}

/// A part in the window of a frame, with little more than the kerfs between them.
TEST(Tabs, StandBesideTheKerfsOfWindows) {
  const std::string nested =
      dxf(rectangle("PROFILE_D3", 0, 0, 100, 80) + rectangle("INSIDE_D3", 20, 20, 80, 60) +
          rectangle("PROFILE_D3", 25, 25, 70, 55));
  const auto result =
      plan_part(read::read_part_text(nested, "nested.dxf", asking()), with_mill("endmill:2", 3));
  EXPECT_EQ(faults_of(result.findings), "");
  EXPECT_EQ(tabs_in(result.part), 9);
}

TEST(Tabs, NeedNoMoreOfASideThanTheirWidthAndTheCuttersDiameter) {
  for (const double side : {8.8, 10.0}) {
    const Part part =
        read::read_part_text(dxf(rectangle("PROFILE_D3", 0, 0, side, side)), "small.dxf", asking());
    PlanOptions options = with_mill("endmill:3", 4);
    options.tabs.width = 4;
    const auto result = plan_part(part, options);
    EXPECT_EQ(faults_of(result.findings), "") << side;
    EXPECT_EQ(tabs_in(result.part), 4) << side;
  }
}

/// The kerf of a hole that is no wider than two cutters leaves nothing in it to hold.
TEST(Tabs, AreNoMatterWhereNothingIsFreed) {
  for (const double radius : {1.6, 2.0, 4.0}) {
    const std::string holed =
        dxf(rectangle("PROFILE_D3", 0, 0, 60, 40) + circle("INSIDE_D3", 30, 20, radius));
    const auto result =
        plan_part(read::read_part_text(holed, "holed.dxf", asking()), with_mill("endmill:2", 3));
    const auto& said = result.part.diagnostics.items();
    const bool warned = std::any_of(said.begin(), said.end(), [](const Diagnostic& one) {
      return one.severity == Severity::kWarning && one.what.find("tabs of") != std::string::npos;
    });
    EXPECT_EQ(warned, radius > 2) << radius;
  }
}

}  // namespace
}  // namespace clearcut::pipeline
