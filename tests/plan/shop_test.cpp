// What a shop asks for around the clearing itself: entries, leads, feeds, finishing, rest machining. Every program is
// certified from its text; the tests look at how it was made.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "base/random.h"
#include "link/lead.h"
#include "model/work_material.h"
#include "pipeline/check.h"
#include "pipeline/run.h"
#include "post/post.h"
#include "read/gcode/gcode.h"
#include "read/job/read_part.h"
#include "support/plans.h"
#include "support/random/random_parts.h"

namespace clearcut {
namespace {

using test_support::expect_clean;
using test_support::plan_options_with;

Region rectangle(double width, double height) {
  return Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{0, 0}, {width, 0}, {width, height}, {0, height}}), {});
}

Part part_of(Regions target, double depth) {
  Part part;
  part.name = part.source_file = "pocket";
  Feature feature;
  feature.name = "POCKET";
  feature.target = feature.allowed = std::move(target);
  feature.floor_z = -depth;
  part.features.push_back(feature);
  part.workplan.push_back({"STEP", "", 0, {}});
  return part;
}

std::vector<Move> moves_of(const Toolpath& toolpath) {
  std::vector<Move> moves;
  for (const Section& section : toolpath.sections)
    moves.insert(moves.end(), section.moves.begin(), section.moves.end());
  return moves;
}

double steepest(const Toolpath& toolpath) {
  double slope = 0;
  for (const Move& move : moves_of(toolpath)) {
    if (!is_rapid(move.kind) && !move.is_vertical() && move.z_to < move.z_from)
      slope = std::max(slope, (move.z_from - move.z_to) / move.path.length());
  }
  return slope;
}

/// Helices are written in the words of each control, and what it makes of them is an entry for all.
TEST(Entries, OfRoundPocketsKeepTheLimitOnEveryControl) {
  for (const std::string& dialect : post::post_dialects()) {
    for (const double diameter : {7.0, 12.0}) {
      PlanOptions options = plan_options_with({"endmill:3"});
      options.post.dialect = dialect;
      options.engagement_deg = 120;
      const Loop circle =
          loop_from_bulges(std::vector<BulgeVertex>{{{-diameter / 2, 0}, 1}, {{diameter / 2, 0}, 1}});
      const auto plan = pipeline::plan_part(part_of({Region::from_valid_loops(circle, {})}, 2), options);
      EXPECT_EQ(verdict_of(plan.findings), Verdict::kClean) << dialect << ' ' << diameter;
    }
  }
}

TEST(Entries, NoneIsSteeperThanAskedForAndNonePlungesIntoMaterial) {
  for (const char* tool : {"endmill:6", "endmill:6:noplunge"}) {
    for (const EntryKind entry : {EntryKind::kHelix, EntryKind::kRamp, EntryKind::kZigzagRamp}) {
      for (const double angle : {2.0, 8.0}) {
        PlanOptions options = test_support::plan_options_with({tool});
        options.entry = entry;
        options.entry_angle = Radians::of_degrees(angle);
        const auto result = pipeline::plan_part(part_of({rectangle(40, 25)}, 5), options);
        expect_clean(result, tool);
        EXPECT_GT(steepest(result.toolpath), 0);
        EXPECT_LE(steepest(result.toolpath), std::tan(angle * kPi / 180) * 1.01);
        for (const Move& move : moves_of(result.toolpath)) {
          const bool down = !is_rapid(move.kind) && move.is_vertical();
          EXPECT_TRUE(!down || move.z_to >= -3.0) << "only down to the material";
        }
      }
    }
  }
}

TEST(Entries, HelixKeepsItsDiameterOrGivesWayAndSaysSo) {
  PlanOptions options = test_support::plan_options_with({"endmill:6"});
  options.entry = EntryKind::kHelix;
  options.shop.helix_widest = 3;
  const auto wide = pipeline::plan_part(part_of({rectangle(40, 25)}, 3), options);
  expect_clean(wide, "helix of 3 mm");
  for (const Move& move : moves_of(wide.toolpath)) {
    const bool helix = move.path.is_arc() && move.z_to < move.z_from;
    EXPECT_NEAR(helix ? move.path.radius() : 1.5, 1.5, 0.01);
  }
  options.shop.helix_widest = options.shop.helix_narrowest = 30;
  const auto none = pipeline::plan_part(part_of({rectangle(40, 25)}, 3), options);
  expect_clean(none, "no helix of 30 mm");
  bool said = false;
  for (const auto& entry : none.part.diagnostics.items())
    said = said || entry.what.find("the entry asked for does not fit") != std::string::npos;
  EXPECT_TRUE(said);
}

TEST(Entries, APredrilledHoleIsTheWayDownForACutterThatMayNotPlunge) {
  PlanOptions options = test_support::plan_options_with({"endmill:6:noplunge"});
  options.entry = EntryKind::kPlunge;
  options.predrilled = {resolve::parse_predrilled("20,12.5:7")};
  const auto result = pipeline::plan_part(part_of({rectangle(40, 25)}, 5), options);
  expect_clean(result, "predrilled");
  int plunges = 0;
  for (const Move& move : moves_of(result.toolpath)) {
    if (is_rapid(move.kind) || !move.is_vertical() || move.z_to >= move.z_from) continue;
    EXPECT_NEAR(distance(move.path.from, {20, 12.5}), 0, 1e-4);
    ++plunges;
  }
  EXPECT_GT(plunges, 0);
  EXPECT_THROW(resolve::parse_predrilled("20,12"), InputError);
  EXPECT_THROW(resolve::parse_predrilled("20,12:-1"), InputError);
}

TEST(Leads, TouchThePassAndStayInTheLegalArea) {
  Random random(3);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    const double width = random.between(4, 40), height = random.between(4, 40),
                 radius = random.between(0.2, 6);
    const Regions legal{rectangle(width, height)};
    const Path path = link::begun_at(legal[0].outer(), random.between(0, width + height));
    const auto lead = link::lead_for(path, legal, {radius, std::nullopt, 0});
    if (!lead) {
      EXPECT_LT(std::min(width, height), radius / 4 * 0.75) << "a quarter of the length fits";
      continue;
    }
    ++found;
    const Path begun = link::begun_at(path, lead->along);
    EXPECT_NEAR(distance(lead->in.to, begun.front().from), 0, 1e-9);
    const double met = lead->in.is_arc() ? 1 : std::sqrt(0.5);  // a line where no arc has room
    EXPECT_NEAR(dot(lead->in.tangent_at(1), begun.front().tangent_at(0)), met, 1e-9) << "tangential in";
    EXPECT_NEAR(dot(lead->out.tangent_at(0), begun.back().tangent_at(1)), met, 1e-9) << "and out";
    EXPECT_TRUE(lead->in.is_arc() || std::min(width, height) < radius / 2 * 1.001) << "a quarter fits";
    for (const double t : {0.0, 0.3, 0.6, 1.0}) {
      EXPECT_TRUE(legal[0].contains(lead->in.at(t)) || legal[0].boundary_distance(lead->in.at(t)) < 1e-9);
      EXPECT_TRUE(legal[0].contains(lead->out.at(t)) || legal[0].boundary_distance(lead->out.at(t)) < 1e-9);
    }
  }
  EXPECT_GT(found, 100);
}

TEST(Leads, ARingBegunElsewhereIsTheSameRing) {
  const Loop ring = rectangle(30, 20).outer();
  for (const double along : {0.0, 10.0, 30.0, 45.5, 99.999}) {
    const Path path = link::begun_at(ring, along);
    EXPECT_NEAR(length(path), 100, 1e-9);
    EXPECT_EQ(path.front().from, path.back().to);
    for (std::size_t i = 1; i < path.size(); ++i) EXPECT_EQ(path[i].from, path[i - 1].to);
  }
}

TEST(SlotFeed, RulesWhereTheCutterIsInAllRoundAndOnlyThere) {
  const Part part = part_of({rectangle(60, 40)}, 2);
  PlanOptions options = test_support::plan_options_with({"endmill:6"});
  const auto fast = pipeline::plan_part(part, options);
  options.cutting.slot_feed = MmPerMin::of(250);
  const auto slow = pipeline::plan_part(part, options);
  expect_clean(slow, "with slot feed");
  EXPECT_NEAR(slow.findings.all.feed_mm, fast.findings.all.feed_mm, 0.01) << "the same way";
  double slotted = 0, other = 0;
  for (const Move& move : moves_of(slow.toolpath)) {
    if (is_rapid(move.kind) || move.is_vertical()) continue;
    (move.feed == MmPerMin::of(250) ? slotted : other) += move.length();
  }
  const auto& histogram = slow.findings.all.engagement.histogram_mm;
  EXPECT_GE(slotted, histogram[15] + histogram[16] + histogram[17] - 0.5);
  EXPECT_GT(other, 0);
}

TEST(Finishing, LeavesStockFirstAndNothingAtTheEnd) {
  PlanOptions options = test_support::plan_options_with({"endmill:6"});
  options.shop.finish = "all";
  options.shop.finish_stock = 0.4;
  options.shop.finish_depths = 2;
  const auto result = pipeline::plan_part(part_of({rectangle(40, 30)}, 6), options);
  expect_clean(result, "finished");
  ASSERT_EQ(result.toolpath.sections.size(), 3u) << "rough, floor, walls";
  const auto nearest_to_wall = [&](const Section& section) {
    double nearest = 1e9;
    for (const Move& move : section.moves)
      nearest = std::min({nearest, move.path.to.x, move.path.to.y, 40 - move.path.to.x, 30 - move.path.to.y});
    return nearest;
  };
  EXPECT_NEAR(nearest_to_wall(result.toolpath.sections[0]), 3.4, 0.002);
  EXPECT_NEAR(nearest_to_wall(result.toolpath.sections[1]), 3.4, 0.002);
  EXPECT_NEAR(nearest_to_wall(result.toolpath.sections[2]), 3.0, 0.002);
  EXPECT_EQ(result.findings.features[2].layers.size(), 2u);
  EXPECT_LT(result.findings.features[2].figures.engagement.max_deg, 120) << "thin stock only";
}

TEST(Finishing, WallsAreMetAndLeftByLeadsAndRunOverTheirStart) {
  for (const bool lines : {false, true}) {
    PlanOptions options = test_support::plan_options_with({"endmill:6"});
    options.shop.finish = "walls";
    if (lines) options.lead_angle = Radians::of_degrees(30);
    const auto plain = pipeline::plan_part(part_of({rectangle(40, 30)}, 3), options);
    options.shop.lead_overlap = 2;
    const auto over = pipeline::plan_part(part_of({rectangle(40, 30)}, 3), options);
    for (const auto* result : {&plain, &over}) {
      expect_clean(*result, "finished walls");
      const auto& moves = result->toolpath.sections.back().moves;
      const auto at_depth = [](const Move& move) {
        return !is_rapid(move.kind) && move.z_from == -3 && move.z_to == -3;
      };
      const auto off_wall = [](Vec2 p) { return std::min({p.x, p.y, 40 - p.x, 30 - p.y}) - 3; };
      const auto first = std::find_if(moves.begin(), moves.end(), at_depth);
      const auto last = std::find_if(moves.rbegin(), moves.rend(), at_depth);
      ASSERT_NE(first, moves.end());
      EXPECT_GT(off_wall(first->path.from), 0.3);
      EXPECT_GT(off_wall(last->path.to), 0.3);
      EXPECT_EQ(first->path.is_arc(), !lines);
    }
    const double more =
        over.findings.features.back().figures.feed_mm - plain.findings.features.back().figures.feed_mm;
    EXPECT_NEAR(more, 2, 1e-3);
  }
}

TEST(Rest, SmallerToolsCutOnlyWhatLargerOnesLeave) {
  Part part = part_of({rectangle(60, 40)}, 2);
  PlanOptions options = test_support::plan_options_with({"endmill:12", "endmill:4"});
  options.shop.rest = true;
  const auto both = pipeline::plan_part(part, options);
  expect_clean(both, "12 then 4");
  const auto fine = pipeline::plan_part(part, test_support::plan_options_with({"endmill:4"}));
  ASSERT_EQ(both.findings.features.size(), 2u);
  EXPECT_EQ(both.findings.features[1].tool_diameter, 4);
  EXPECT_LT(both.findings.features[1].figures.feed_mm, 0.25 * fine.findings.all.feed_mm);
  EXPECT_NEAR(both.findings.all.unreachable_mm2, fine.findings.all.unreachable_mm2, 0.5)
      << "corners of the 4, not the 12";
}

/// What a larger mill has cut is not milled again, whatever limits the engagement: that were 6421 mm here for four corners.
TEST(Rest, WithinALimitOnlyWhatIsLeftIsCut) {
  for (const std::string style : {"", "machinist"}) {
    PlanOptions options = test_support::plan_options_with({"endmill:6", "endmill:2"});
    options.shop.rest = true;
    if (style.empty())
      options.strategy = "adaptive";
    else
      options.shop.style = style;
    const auto result = pipeline::plan_part(part_of({rectangle(40, 30)}, 2), options);
    expect_clean(result, style);
    ASSERT_EQ(result.findings.features.size(), 2u);
    EXPECT_LT(result.findings.features[1].figures.feed_mm, 400) << style;
  }
}

TEST(Rest, RandomPocketsAreCleanWithTwoTools) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    PlanOptions options = test_support::plan_options_with({"endmill:9", "endmill:3.5"});
    options.shop.rest = true;
    const double size = random.between(20, 50);
    const Vec2 corners[] = {
        {0, 0}, {size, random.between(-5, 5)}, {size * 0.9, size}, {size * 0.5, size * 0.7}, {0, size}};
    const auto result =
        pipeline::plan_part(part_of({Region::from_valid_loops(loop_from_points(corners), {})}, 3), options);
    expect_clean(result, "seed " + std::to_string(seed));
  }
}

/// Above the rounding of its corners a bull-nose reaches further into a corner than on the floor, where nothing may be left to it.
TEST(Rest, ByBullNosesIsCutAsFarAsTheirSidesReach) {
  struct Row {
    const char* large;
    const char* small;
    double depth;
    std::vector<Vec2> outline;
  };
  const Row rows[] = {
      {"endmill:8",
       "bullnose:4:corner=1",
       1.5,
       {{21.6973, 14.8486}, {10.6175, 21.1649}, {2.0823, 11.1778}, {14.9282, 3.4088}}},
      {"endmill:12",
       "bullnose:5:corner=2.4",
       0.6,
       {{25.1525, 25.6352}, {10.0587, 27.8762}, {2.9642, 15.8989}, {15.1856, 4.2361}, {27.4741, 9.8377}}},
  };
  for (const Row& row : rows) {
    PlanOptions options = test_support::plan_options_with({row.large, row.small});
    options.shop.rest = true;
    options.strategy = "adaptive";
    options.accept = {"out-of-reach"};
    const Region outline = Region::from_valid_loops(loop_from_points(row.outline), {});
    expect_clean(pipeline::plan_part(part_of({outline}, row.depth), options), row.small);
  }
}

/// What the widest cutters leave in corners is cut before the pockets under it, also where rest machining is not asked for.
TEST(Rest, SeveralCuttersChosenBySizeLeaveNothingOverWhatLiesUnder) {
  const Part part = read::read_part(std::string(CLEARCUT_SOURCE_DIR) + "/examples/fishhead.p21", {});
  for (const bool rest : {false, true}) {
    PlanOptions options;
    for (const char* tool : {"facemill:40", "endmill:20", "endmill:10", "endmill:6", "endmill:4"})
      options.tools.push_back(resolve::parse_tool(tool));
    options.strategy = "zigzag";
    options.shop.rest = rest;
    for (const auto& fault : pipeline::plan_part(part, options).findings.faults) ADD_FAILURE() << fault.text;
  }
}

TEST(Rest, AnEarlierProgramIsTakenIntoAccountAndCertifiedWith) {
  const Part part = part_of({rectangle(60, 40)}, 2);
  const auto before = pipeline::plan_part(part, test_support::plan_options_with({"endmill:12:T3"}));
  PlanOptions options = test_support::plan_options_with({"endmill:12:T3", "endmill:4:T1"});
  options.earlier = read::gcode::read_gcode(before.program, "before.ngc").toolpath;
  const auto after = pipeline::plan_part(part, options);
  expect_clean(after, "after");
  EXPECT_EQ(after.toolpath.sections.at(0).tool_number, 1);
  EXPECT_LT(
      after.findings.all.feed_mm,
      0.25 * pipeline::plan_part(part, test_support::plan_options_with({"endmill:4"})).findings.all.feed_mm);
  CheckResult alone = pipeline::check_program(part, after.program, "after.ngc",
                                              test_support::plan_options_with({"endmill:4:T1"}));
  EXPECT_FALSE(alone.findings.all.clean) << "without the earlier program nearly all is left";
}

/// What the certificate allows anyway is not cut once more, whatever the strategies.
TEST(Rest, AfterAProgramOfTheSameCutterNothingIsCut) {
  int programs = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    const Part part = test_support::random_part(random, 6);
    PlanOptions options;
    options.strategy = seed % 2 ? "contour" : "zigzag";
    PlanResult before;
    try {
      before = pipeline::plan_part(part, options);
    } catch (const InputError&) {
      continue;
    }
    options.earlier = read::gcode::read_gcode(before.program, "before.ngc").toolpath;
    const auto after = pipeline::plan_part(part, options);
    EXPECT_EQ(after.findings.all.feed_mm, 0) << "seed " << seed;
    EXPECT_EQ(after.findings.all.clean, before.findings.all.clean) << "seed " << seed;
    ++programs;
  }
  EXPECT_GT(programs, 6);
}

TEST(Shop, RapidsThatNeedAFeedHaveTheMachines) {
  PlanOptions options = test_support::plan_options_with({"endmill:6"});
  options.post.dialect = "marlin";
  options.machine.rapid = MmPerMin::of(1800);
  const std::string program = pipeline::plan_part(part_of({rectangle(20, 15)}, 2), options).program;
  EXPECT_THAT(program, ::testing::ContainsRegex("G0 Z[0-9.]+ F1800\n"));
}

TEST(Shop, ImpossibleOptionsAreRefusedByName) {
  const auto refused = [](auto&& change) {
    PlanOptions options;
    change(options);
    try {
      resolve::check(options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  using ::testing::HasSubstr;
  EXPECT_THAT(refused([](PlanOptions& o) { o.shop.finish = "ceiling"; }),
              HasSubstr("--finish: 'ceiling' is unknown; use one of walls, floor, all"));
  EXPECT_THAT(refused([](PlanOptions& o) { o.shop.finish_depths = 1.5; }), HasSubstr("--finish-depths"));
  EXPECT_THAT(refused([](PlanOptions& o) { o.shop.material = "cheese"; }),
              HasSubstr("'cheese' is unknown; use one of"));
  EXPECT_THAT(refused([](PlanOptions& o) { o.lead = -1; }), HasSubstr("--lead"));
  EXPECT_THAT(refused([](PlanOptions& o) { o.entry_angle = Radians::of_degrees(95); }),
              HasSubstr("--entry-angle"));
}

}  // namespace
}  // namespace clearcut
