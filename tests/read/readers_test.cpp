// All readers of drawings on the shared drawings and shapes, and on the examples.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "base/error.h"
#include "base/units.h"
#include "geometry/contours/boolean.h"
#include "post/part/part_writers.h"
#include "read/job/job_file.h"
#include "read/job/read_part.h"
#include "read/outline/outline_reader.h"
#include "read/repair/meetings.h"
#include "support/command.h"
#include "support/data.h"
#include "support/drawings.h"
#include "support/read_parts.h"
#include "support/shapes.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;
using test_support::area_of;
using test_support::depth_2;

Part drawing(const std::string& name) {
  return read::read_part(*test_support::data_folder() / "drawings" / name, depth_2());
}

std::size_t loops_of(const Part& part) {
  std::size_t count = 0;
  for (const Feature& feature : part.features) {
    for (const Region& region : feature.target) count += 1 + region.islands().size();
  }
  return count;
}

Box box_of(const Part& part) {
  Box all;
  for (const Feature& feature : part.features) all.add(box(feature.target));
  return all;
}

int said(const Part& part, Severity severity, const std::string& text = "") {
  return static_cast<int>(std::count_if(
      part.diagnostics.items().begin(), part.diagnostics.items().end(), [&](const Diagnostic& d) {
        return d.severity == severity && (d.where + ": " + d.what).find(text) != std::string::npos;
      }));
}

void expect_valid(const Part& part) {
  for (const Feature& feature : part.features) {
    for (const Region& region : feature.target) {
      std::vector<Loop> loops{region.outer()};
      loops.insert(loops.end(), region.islands().begin(), region.islands().end());
      for (const read::Meeting& meeting : read::meetings(loops, 100000, "test"))
        EXPECT_EQ(meeting.kind, read::MeetingKind::kTouch);
    }
  }
}

Part own_drawing(const std::string& text, const std::string& name) {
  Part part = read::read_part_text(text, name, depth_2());
  expect_valid(part);
  return part;
}

int arcs_of(const Region& region) {
  const auto edges = region.edges();
  return static_cast<int>(
      std::count_if(edges.begin(), edges.end(), [](const Edge& e) { return e.is_arc(); }));
}

TEST(OwnDrawings, GearWithGaps) {
  const Part part = own_drawing(test_support::gear_with_gaps_dxf(), "gear.dxf");
  ASSERT_EQ(part.features.size(), 1u);
  EXPECT_EQ(loops_of(part), 2u);
  EXPECT_EQ(part.features[0].target[0].outer().size(), 48u);
  EXPECT_EQ(arcs_of(part.features[0].target[0]), 8);
  EXPECT_NEAR(box_of(part).width(), 27.96, 0.01);
  EXPECT_EQ(said(part, Severity::kWarning, "millimetres assumed"), 1);
  EXPECT_EQ(said(part, Severity::kRepair, "closed a gap of 0.0001 mm"), 48);
}

TEST(OwnDrawings, NecksInMillimetres) {
  const Part part = own_drawing(test_support::narrow_necks_dxf(), "necks.dxf");
  EXPECT_EQ(loops_of(part), 2u);
  EXPECT_NEAR(area_of(part), 322 - kPi, 1e-6);
  EXPECT_EQ(said(part, Severity::kWarning), 0);
  EXPECT_EQ(said(part, Severity::kRepair), 0);
}

TEST(OwnDrawings, OldPolylinesThatAreClosedInFact) {
  const Part part = own_drawing(test_support::old_polylines_dxf(), "old.dxf");
  EXPECT_EQ(loops_of(part), 12u);
  EXPECT_NEAR(area_of(part), 120000, 1e-6);
  EXPECT_EQ(said(part, Severity::kWarning, "550 x 400"), 1);
}

TEST(OwnDrawings, BulgesAboveOneAndBelowZero) {
  const Part part = own_drawing(test_support::bulges_dxf(), "bulges.dxf");
  ASSERT_EQ(part.features.size(), 1u);
  const Region& region = part.features[0].target[0];
  ASSERT_EQ(region.islands().size(), 2u);
  EXPECT_EQ(arcs_of(region), 9);
  const auto edges = region.edges();
  EXPECT_EQ(std::count_if(edges.begin(), edges.end(),
                          [](const Edge& e) { return std::abs(e.sweep()) > kPi + 1e-9; }),
            1);
  EXPECT_NEAR(box_of(part).max.x, 135, 1e-9);  // sagitta 0.5 * 60 / 2
  EXPECT_NEAR(box_of(part).max.y, 90, 1e-9);   // sagitta 1.5 * 40 / 2
}

TEST(OwnDrawings, SquaresThatTouchKeepTheirArea) {
  const Part part = own_drawing(test_support::touching_squares_svg(), "touch.svg");
  EXPECT_EQ(loops_of(part), 10u);
  EXPECT_EQ(said(part, Severity::kNote, "two outlines touch"), 12);
  EXPECT_NEAR(area_of(part), 1000, 1e-6);
}

TEST(OwnDrawings, TracedOutline) {
  const Part part = own_drawing(test_support::traced_svg(), "trace.svg");
  ASSERT_EQ(loops_of(part), 1u);
  EXPECT_NEAR(box_of(part).width(), 68.22, 0.01);
  EXPECT_EQ(said(part, Severity::kWarning, "96 px per inch"), 1);
}

// Published drawings, where they are; they only add to the own ones. Counts, sizes and units are those of their README.

TEST(Drawings, GearWithGapsAndABlockThatIsNeverInserted) {
  if (!test_support::data_folder()) return;
  const Part part = drawing("gear-endpoint-gaps.dxf");
  ASSERT_EQ(part.features.size(), 1u);
  EXPECT_EQ(loops_of(part), 2u);
  const auto& region = part.features[0].target[0];
  EXPECT_EQ(region.outer().size() + region.islands()[0].size(), 332u + 32u);
  EXPECT_EQ(
      std::count_if(region.outer().begin(), region.outer().end(), [](const Edge& e) { return e.is_arc(); }) +
          std::count_if(region.islands()[0].begin(), region.islands()[0].end(),
                        [](const Edge& e) { return e.is_arc(); }),
      32);
  EXPECT_NEAR(box_of(part).width(), 32, 0.3);
  EXPECT_EQ(said(part, Severity::kWarning, "millimetres assumed"), 1);
  EXPECT_EQ(said(part, Severity::kRepair, "closed a gap of 0.000134 mm"), 2);
  expect_valid(part);
}

TEST(Drawings, SlotProfileInMillimetres) {
  if (!test_support::data_folder()) return;
  const Part part = drawing("vslot-narrow-necks.dxf");
  EXPECT_EQ(loops_of(part), 2u);
  EXPECT_NEAR(box_of(part).width(), 20, 1e-9);
  EXPECT_EQ(said(part, Severity::kWarning), 0);
  EXPECT_EQ(said(part, Severity::kRepair), 0);
  expect_valid(part);
}

TEST(Drawings, OldPolylinesThatAreClosedInFact) {
  if (!test_support::data_folder()) return;
  const Part part = drawing("polylines-no-units.dxf");
  EXPECT_EQ(loops_of(part), 29u);
  EXPECT_NEAR(box_of(part).width(), 571.5, 1e-6);
  EXPECT_NEAR(box_of(part).height(), 317.5, 1e-6);
  EXPECT_EQ(said(part, Severity::kWarning, "571.5 x 317.5"), 1);
  expect_valid(part);
}

TEST(Drawings, BulgesAboveOneAndBelowZero) {
  if (!test_support::data_folder()) return;
  const Part part = drawing("bulge-polylines.dxf");
  ASSERT_EQ(part.features.size(), 1u);
  ASSERT_EQ(part.features[0].target[0].islands().size(), 2u);
  int arcs = 0, more_than_half = 0;
  for (const Edge& edge : part.features[0].target[0].edges()) {
    arcs += edge.is_arc() ? 1 : 0;
    more_than_half += std::abs(edge.sweep()) > kPi + 1e-9 ? 1 : 0;
  }
  EXPECT_EQ(arcs, 8);
  EXPECT_GT(more_than_half, 0);
  expect_valid(part);
}

TEST(Drawings, ContoursThatTouchAreSplitAndKeepTheirArea) {
  if (!test_support::data_folder()) return;
  const Part part = drawing("touching-contours-88.svg");
  EXPECT_GE(loops_of(part), 88u);
  EXPECT_GT(said(part, Severity::kRepair, "touches itself"), 0);
  EXPECT_GT(said(part, Severity::kNote, "two outlines touch"), 0);
  expect_valid(part);
  // A second method: the library's own non-zero rule on all contours at once.
  std::vector<Loop> all;
  for (const Feature& feature : part.features) {
    for (const Region& region : feature.target) {
      all.push_back(region.outer());
      all.insert(all.end(), region.islands().begin(), region.islands().end());
    }
  }
  EXPECT_NEAR(area(resolve_nonzero(all, Tolerances{})), area_of(part), 1e-3);
}

TEST(Drawings, TracedRabbit) {
  if (!test_support::data_folder()) return;
  const Part part = drawing("rabbit-trace.svg");
  ASSERT_EQ(loops_of(part), 1u);
  EXPECT_NEAR(static_cast<double>(part.features[0].target[0].outer().size()), 133, 1);
  EXPECT_EQ(said(part, Severity::kWarning, "96 px per inch"), 1);
}

TEST(Shapes, AllLoadWithoutMendsAndSurviveARoundTrip) {
  const auto shapes = test_support::all_shapes();
  for (const auto& shape : shapes) {
    const Part part = test_support::part_of(shape);
    EXPECT_EQ(said(part, Severity::kRepair), 0) << shape.name;
    expect_valid(part);
    const Part again = read::read_outline_json(post::write_outline_json(part), "again.json", Tolerances{});
    ASSERT_EQ(again.features.size(), part.features.size());
    EXPECT_NEAR(area_of(again), area_of(part), 1e-6);
    EXPECT_EQ(again.features[0].top_z, part.features[0].top_z);
    EXPECT_EQ(again.features[0].floor_z, part.features[0].floor_z);
    EXPECT_EQ(again.features[0].wall_slope, part.features[0].wall_slope);
  }
  EXPECT_GE(shapes.size(), 16u);
}

TEST(Shapes, OpenSidesStockAndKindsSurviveTheOutlineFormat) {
  const Part part = read::read_part(fs::path(CLEARCUT_SOURCE_DIR) / "examples/fishhead.p21", {});
  const std::string text = post::write_outline_json(part);
  const Part again = read::read_outline_json(text, "again.json", Tolerances{});
  ASSERT_TRUE(again.stock);
  EXPECT_EQ(again.stock->plan.max, part.stock->plan.max);
  std::size_t regions = 0;
  double allowed = 0, allowed_again = 0;
  for (const Feature& feature : part.features) {
    regions += feature.target.size();
    if (feature.target.size() == 1) allowed += area(feature.allowed);
  }
  ASSERT_EQ(again.features.size(), regions);
  for (const Feature& feature : again.features) allowed_again += area(feature.allowed);
  if (regions == part.features.size()) {
    EXPECT_NEAR(allowed_again / allowed, 1, 1e-9);
  }
}

TEST(Shapes, FilletsOfFloorsSurviveTheOutlineFormat) {
  Part part = read::read_outline_json(
      R"({"units": "in", "outer": [[0, 0], [1, 0], [1, 1], [0, 1]], "depth": 0.5, "floor_fillet": 0.0625})",
      "part.json", Tolerances{});
  EXPECT_DOUBLE_EQ(part.features[0].floor_fillet, 1.5875);
  const Part again = read::read_outline_json(post::write_outline_json(part), "again.json", Tolerances{});
  EXPECT_EQ(again.features[0].floor_fillet, part.features[0].floor_fillet);
}

/// Every edge of `a` lies within `limit` mm of the boundary of `b`.
void expect_near(const Region& a, const Region& b, double limit) {
  for (const Edge& edge : a.edges()) {
    for (const double t : {0.0, 0.3, 0.7}) EXPECT_LT(b.boundary_distance(edge.at(t)), limit);
  }
}

/// The same region in three formats: everything in one and not in the other is thinner than 1 um.
TEST(Examples, BracketIsTheSameRegionAsDxfSvgAndJson) {
  const fs::path examples = fs::path(CLEARCUT_SOURCE_DIR) / "examples";
  const Part json = read::read_part(examples / "bracket.json", {});
  ASSERT_EQ(json.features.size(), 1u);
  const double expected = 80 * 50 - 36 * (4 - kPi) - 32 * kPi - 36 * kPi - (12 * 8 + 16 * kPi);
  EXPECT_NEAR(area_of(json), expected, 1e-9);
  for (const char* name : {"bracket.dxf", "bracket.svg"}) {
    const Part part = read::read_part(examples / name, {});
    ASSERT_EQ(part.features.size(), 1u) << name;
    EXPECT_TRUE(part.diagnostics.items().empty()) << name;
    EXPECT_DOUBLE_EQ(part.features[0].floor_z, json.features[0].floor_z) << name;
    EXPECT_NEAR(area_of(part), expected, 1e-6) << name;
    expect_near(part.features[0].target[0], json.features[0].target[0], 1e-3);
    expect_near(json.features[0].target[0], part.features[0].target[0], 1e-3);
  }
}

TEST(Examples, TheJobOfTheBracketIsReadWhole) {
  const fs::path examples = fs::path(CLEARCUT_SOURCE_DIR) / "examples";
  const Part part = read::read_part(examples / "bracket.toml", {});
  ASSERT_EQ(part.features.size(), 1u);
  EXPECT_EQ(part.tools.size(), 2u);
  ASSERT_EQ(part.workplan.size(), 2u);
  EXPECT_EQ(part.workplan[1].operation.kind, OperationKind::kFinishing);
  EXPECT_DOUBLE_EQ(part.workplan[0].operation.allowance_side, 0.2);
  ASSERT_TRUE(part.stock);
  EXPECT_DOUBLE_EQ(part.stock->plan.width(), 90);
  const JobFile job = read::read_job(examples / "bracket.toml");
  EXPECT_EQ(job.machine.name, "desktop mill");
}

}  // namespace
}  // namespace clearcut
