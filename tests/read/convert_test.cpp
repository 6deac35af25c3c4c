// A part keeps its program on the way through another format.
#include <gtest/gtest.h>

#include "base/file.h"
#include "features/derived_outlines.h"
#include "pipeline/run.h"
#include "post/part/part_writers.h"
#include "read/job/read_part.h"
#include "resolve/resolve.h"
#include "support/data.h"
#include "support/drawings.h"
#include "support/programs.h"
#include "support/same_regions.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;

struct Drawing {
  std::string file;
  std::string text;
  const char* tool;
};

Drawing drawing(const fs::path& file, const char* tool) {
  return {file.filename().string(), read_file(file.string()), tool};
}

std::vector<Drawing> drawings() {
  std::vector<Drawing> all{drawing(fs::path(CLEARCUT_SOURCE_DIR) / "examples/bracket.dxf", "endmill:6"),
                           drawing(fs::path(CLEARCUT_SOURCE_DIR) / "examples/bracket.svg", "endmill:6"),
                           {"bulges.dxf", test_support::bulges_dxf(), "endmill:20"},
                           {"necks.dxf", test_support::narrow_necks_dxf(), "endmill:2"}};
  if (const auto data = test_support::data_folder()) {
    all.push_back(drawing(*data / "drawings/bulge-polylines.dxf", "endmill:20"));
    all.push_back(drawing(*data / "drawings/vslot-narrow-necks.dxf", "endmill:2"));
    all.push_back(drawing(*data / "drawings/gear-endpoint-gaps.dxf", "endmill:2"));
  }
  return all;
}

/// The program without its header, whose first lines name the part's file and format.
std::string program_of(const Part& part, const PlanOptions& options) {
  const std::string program = pipeline::plan_part(part, options).program;
  return program.substr(program.find("G21"));
}

TEST(Convert, ADrawingAsStepNcHasTheSameProgram) {
  for (const Drawing& drawing : drawings()) {
    ReadOptions reading;
    reading.depth_if_missing = 2;
    const Part drawn = read::read_part_text(drawing.text, drawing.file, reading);
    PlanOptions options;
    options.tools = {resolve::parse_tool(drawing.tool)};
    const std::string wanted = program_of(drawn, options);
    const Part stepnc =
        read::read_part_text(post::write_stepnc(resolve::with_tools(drawn, options)), "again.p21", {});
    EXPECT_EQ(test_support::first_difference(program_of(stepnc, options), wanted), "") << drawing.file;
  }
}

Region rectangle(double x, double y, double width, double height) {
  return Region::from_valid_loops(
      {Edge::line({x, y}, {x + width, y}), Edge::line({x + width, y}, {x + width, y + height}),
       Edge::line({x + width, y + height}, {x, y + height}), Edge::line({x, y + height}, {x, y})},
      {});
}

ProfileCut along(ProfileSide side, bool closed) {
  ProfileCut cut;
  cut.side = side;
  cut.closed = closed;
  cut.line = rectangle(3, 4, 20, 10).outer();
  if (!closed) cut.line.pop_back();
  if (side != ProfileSide::kOn) cut.beyond = 0.5;
  return cut;
}

/// A part with one feature of `kind`.
Part part_of(FeatureKind kind) {
  const Tolerances tol;
  Feature feature;
  feature.name = "one";
  feature.kind = kind;
  feature.floor_z = -2.5;
  feature.target = {rectangle(0, 0, 30, 20)};
  feature.allowed = feature.target;
  if (kind == FeatureKind::kRoundHole) {
    const Vec2 left{-4, 1}, right{6, 1}, center{1, 1};
    feature.target = {Region::from_valid_loops({Edge::arc(left, right, center, Turn::kCounterClockwise),
                                                Edge::arc(right, left, center, Turn::kCounterClockwise)},
                                               {})};
    feature.allowed = feature.target;
    feature.hole_diameter = 10;
  }
  if (kind == FeatureKind::kOpenPocket) feature.allowed = {rectangle(0, 0, 1030, 20)};
  feature.through = kind == FeatureKind::kInsideProfile;
  if (kind == FeatureKind::kInsideProfile) features::follow(feature, along(ProfileSide::kInside, true), tol);
  if (kind == FeatureKind::kOutsideProfile)
    features::follow(feature, along(ProfileSide::kOutside, true), tol);
  if (kind == FeatureKind::kEngraving) features::follow(feature, along(ProfileSide::kOn, false), tol);
  Part part;
  part.name = "kinds";
  part.features = {std::move(feature)};
  return part;
}

TEST(Convert, EveryKindOfFeatureComesBackFromOutlineJson) {
  for (const FeatureKind kind :
       {FeatureKind::kClosedPocket, FeatureKind::kOpenPocket, FeatureKind::kPlanarFace, FeatureKind::kSlot,
        FeatureKind::kStep, FeatureKind::kRoundHole, FeatureKind::kOutsideProfile,
        FeatureKind::kInsideProfile, FeatureKind::kEngraving}) {
    SCOPED_TRACE(name_of(kind));
    const Part part = part_of(kind);
    const std::string text = post::write_outline_json(part);
    const Part again = read::read_part_text(text, "again.json", {});
    ASSERT_EQ(again.features.size(), 1u);
    const Feature &was = part.features[0], &is = again.features[0];
    EXPECT_EQ(is.kind, kind);
    EXPECT_EQ(is.through, was.through);
    EXPECT_EQ(is.floor_z, was.floor_z);
    EXPECT_LT(test_support::boundary_gap(is.target, was.target), 1e-9);
    EXPECT_LT(test_support::boundary_gap(is.allowed, was.allowed), 1e-9);
    ASSERT_EQ(is.profile.has_value(), was.profile.has_value());
    if (!was.profile) continue;
    EXPECT_EQ(is.profile->side, was.profile->side);
    EXPECT_EQ(is.profile->closed, was.profile->closed);
    EXPECT_EQ(is.profile->beyond, was.profile->beyond);
    EXPECT_EQ(is.profile->line, was.profile->line);
    EXPECT_EQ(post::write_outline_json(again), text);
  }
}

TEST(Convert, ADrawingWithProfilesAsOutlineJsonHasTheSameProgram) {
  const Drawing drawn = drawing(fs::path(CLEARCUT_SOURCE_DIR) / "examples/bracket.dxf", "endmill:3");
  ReadOptions reading;
  reading.depth_if_missing = 2;
  const Part part = read::read_part_text(drawn.text, drawn.file, reading);
  PlanOptions options;
  options.tools = {resolve::parse_tool(drawn.tool)};
  const Part again = read::read_part_text(post::write_outline_json(part), "again.json", {});
  EXPECT_EQ(test_support::first_difference(program_of(again, options), program_of(part, options)), "");
}

}  // namespace
}  // namespace clearcut
