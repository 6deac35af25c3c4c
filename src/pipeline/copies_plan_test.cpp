// One part several times on one sheet: what the text of the one program makes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "base/random.h"
#include "options/copies_options.h"
#include "pipeline/check.h"
#include "pipeline/copies.h"
#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

/// A plate 40 by 30 mm with a pocket and two holes.
Part plate() {
  return drawn(box("STOCK_D8", 0, 0, 40, 30) + rounded_box("POCKET_D4", 5, 5, 25, 25, 4) +
               circle("DRILL_D8", {32, 8}, 2.5) + circle("DRILL_D8", {32, 22}, 2.5));
}

std::size_t tool_changes(const Toolpath& toolpath) {
  std::size_t changes = 0;
  for (std::size_t i = 1; i < toolpath.sections.size(); ++i)
    changes += toolpath.sections[i].tool_number != toolpath.sections[i - 1].tool_number ? 1 : 0;
  return changes;
}

PlanOptions in_grid(PlanOptions options, const std::string& counts, std::optional<double> gap) {
  options.copies.grid = counts;
  options.copies.gap = gap;
  return options;
}

/// What is cut apart from the outlines that are cut out is of the part, too: it lies on the sheet, beside the other copies.
TEST(Copies, WhatLiesBesideTheOutlinesIsOfThePart) {
  const Part part = drawn(box("PROFILE_D3", 0, 40, 20, 60) + box("INSIDE_D3", 30, 0, 42, 12) +
                          box("POCKET_D2", -30, 2, -10, 14));
  for (const char* sheet : {"160x140", "140x160"}) {
    PlanOptions options = with({"endmill:3"});
    options.copies.sheet = sheet;
    options.copies.edge = 2;
    const PlanResult result = plan_part(part, options);
    EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings);
    ASSERT_TRUE(result.copies);
    EXPECT_EQ(result.copies->parts, 4);
  }
}

/// Where a part ends with a pocket, its wall is the material beside it: none at the sheet's edge, or towards the next, was found as uncut.
TEST(Copies, PocketsAtTheSideOfTheirPartNeedAWall) {
  const Part part = drawn(rounded_box("POCKET_D2", 0, 0, 20, 14, 2));
  const auto said = [&](double edge, double gap) {
    PlanOptions options = with({"endmill:3"});
    options.copies.sheet = "100x60";
    options.copies.edge = edge;
    options.copies.gap = gap;
    try {
      const PlanResult planned = plan_part(part, options);
      EXPECT_TRUE(planned.findings.all.clean) << faults_of(planned.findings);
      EXPECT_TRUE(check_program(part, planned.program, "sheet.ngc", options).findings.all.clean);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no refusal");
  };
  EXPECT_THAT(said(0, 3), HasSubstr("--edge: 0 mm leave no wall of POCKET_D2"));
  EXPECT_THAT(said(3, 0), HasSubstr("--gap: 0 mm between parts leave no wall of POCKET_D2"));
  EXPECT_EQ(said(0.5, 0.5), "no refusal");
}

TEST(Copies, EachPartIsMadeAndEachToolComesOnce) {
  const PlanOptions options = with({"endmill:6", "drill:5"});
  const PlanResult result = plan_part(plate(), in_grid(options, "3x2", 4));
  EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings);
  ASSERT_TRUE(result.copies);
  EXPECT_EQ(result.copies->parts, 6);
  EXPECT_EQ(result.copies->clean_parts, 6);
  EXPECT_EQ(result.copies->sheet.width(), 128);
  EXPECT_EQ(result.copies->sheet.height(), 64);
  EXPECT_EQ(tool_changes(result.toolpath), 1U);
  std::set<std::string> names;
  for (const Feature& feature : result.part.features) names.insert(feature.name);
  EXPECT_EQ(names.size(), result.part.features.size());
  // One part's path six times.
  const PlanResult one = plan_part(plate(), options);
  EXPECT_FALSE(one.copies);
  EXPECT_NEAR(result.findings.all.feed_mm, 6 * one.findings.all.feed_mm, 0.01);
}

/// A program in which one copy is not cut is at fault for that part alone.
TEST(Copies, APartThatIsLeftOutIsMissed) {
  const PlanOptions options = with({"endmill:6", "drill:5"});
  const PlanOptions two = in_grid(options, "2x1", 4);
  const PlanResult sheet = plan_part(plate(), two);
  const CheckResult whole = check_program(plate(), sheet.program, "sheet.ngc", two);
  EXPECT_TRUE(whole.findings.all.clean) << faults_of(whole.findings);
  ASSERT_TRUE(whole.copies);
  EXPECT_EQ(whole.copies->clean_parts, 2);
  const PlanResult one = plan_part(plate(), in_grid(options, "1x1", 4));
  const CheckResult missing = check_program(plate(), one.program, "one.ngc", two);
  EXPECT_FALSE(missing.findings.faults.empty());
  for (const Fault& fault : missing.findings.faults) EXPECT_THAT(fault.feature, HasSubstr(".2"));
  EXPECT_EQ(missing.copies->parts, 2);
  EXPECT_EQ(missing.copies->clean_parts, 1);
}

/// A plate 30 by 20 mm that is cut out of a plain sheet.
Part cut_out_plate() {
  return drawn(box("STOCK_D3", -10, -10, 40, 30) + box("OUTSIDE_D3", 0, 0, 30, 20) +
               circle("DRILL_D3", {10, 10}, 2));
}

/// Parts that are cut out of a plain sheet stand a kerf apart: as stated, or of itself.
TEST(Copies, CutOutsNeedTheKerf) {
  PlanOptions options = with({"endmill:4", "drill:4"});
  options.accept = {"loose-part"};
  try {
    plan_part(cut_out_plate(), in_grid(options, "2x2", 3));
    ADD_FAILURE() << "no refusal";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("3 mm between parts is less than the cutter needs"));
  }
  const PlanResult sheet = plan_part(cut_out_plate(), in_grid(options, "2x2", 10));
  EXPECT_TRUE(sheet.findings.faults.empty()) << faults_of(sheet.findings);
  ASSERT_TRUE(sheet.copies);
  EXPECT_EQ(sheet.copies->clean_parts, 4);
  EXPECT_EQ(sheet.copies->sheet.width(), 90);
  EXPECT_EQ(sheet.copies->sheet.height(), 70);
  const PlanResult close = plan_part(cut_out_plate(), in_grid(options, "2x2", {}));
  EXPECT_TRUE(close.findings.faults.empty()) << faults_of(close.findings);
  ASSERT_TRUE(close.copies);
  EXPECT_EQ(close.copies->clean_parts, 4);
  EXPECT_GE(close.copies->gap, 4);
  EXPECT_LT(close.copies->gap, 10);
}

/// Turned where that makes more parts; every part is certified where it lies.
TEST(Copies, ASheetIsFilledAndPartsAreTurned) {
  PlanOptions options = with({"endmill:6", "drill:5"});
  options.copies.sheet = "125x74";
  options.copies.gap = 2;
  options.copies.edge = 1;
  const PlanResult planned = plan_part(plate(), options);
  EXPECT_TRUE(planned.findings.all.clean) << faults_of(planned.findings);
  ASSERT_TRUE(planned.copies);
  EXPECT_GT(planned.copies->turned, 0);
  EXPECT_GT(planned.copies->parts, planned.copies->turned);
  EXPECT_EQ(planned.copies->clean_parts, planned.copies->parts);
  EXPECT_LE(planned.copies->parts, *planned.copies->at_most);
  const CheckResult read = check_program(plate(), planned.program, "sheet.ngc", options);
  EXPECT_TRUE(read.findings.all.clean) << faults_of(read.findings);
  options.copies.count = 2;
  EXPECT_EQ(plan_part(plate(), options).copies->parts, 2);
  options.copies.sheet = "30x20";
  EXPECT_THROW(plan_part(plate(), options), InputError);
}

/// Clamps of a sheet are in its coordinates; the parts that would come too near to one are left out.
TEST(Copies, ClampsOfTheSheetAreKeptFree) {
  PlanOptions options = with({"endmill:6", "drill:5"});
  options.copies.sheet = "130x66";
  options.copies.gap = 2;
  const int all = plan_part(plate(), options).copies->parts;
  KeepOut clamp;
  clamp.plan.add(Vec2{0, 0});
  clamp.plan.add(Vec2{12, 9});
  clamp.bottom_z = -8;
  clamp.top_z = 12;
  options.keep_outs = {clamp};
  const PlanResult planned = plan_part(plate(), options);
  EXPECT_TRUE(planned.findings.all.clean) << faults_of(planned.findings);
  EXPECT_EQ(planned.copies->parts, all - 1);
  EXPECT_EQ(planned.copies->clean_parts, all - 1);
  const CheckResult read = check_program(plate(), planned.program, "sheet.ngc", options);
  EXPECT_TRUE(read.findings.all.clean) << faults_of(read.findings);
}

/// A plate with rounded corners, 60 by 24 mm, that is cut out of a plain sheet.
Part rounded_plate() {
  return drawn(box("STOCK_D3", -10, -10, 70, 34) + rounded_box("OUTSIDE_D3", 0, 0, 60, 24, 5));
}

std::string conditions_named(const Findings& findings) {
  std::string names;
  for (const Condition& one : findings.conditions) names += one.name + " ";
  return names;
}

/// Tabs have the same places on each copy, turned ones too: programs of copies are checked with them, and one without tabs is at fault.
TEST(Copies, TabsOfEachCopyAreChecked) {
  PlanOptions options = with({"endmill:4", "drill:4"});
  options.tabs.count = 3;
  PlanOptions grid = in_grid(options, "2x2", 12), sheet = options;
  sheet.copies.sheet = "160x120";
  sheet.copies.gap = 12;
  for (const Part& part : {cut_out_plate(), rounded_plate()}) {
    for (const PlanOptions& asked : {grid, sheet}) {
      const PlanResult planned = plan_part(part, asked);
      EXPECT_EQ(faults_of(planned.findings), "");
      EXPECT_EQ(planned.copies->clean_parts, planned.copies->parts);
      const CheckResult read = check_program(part, planned.program, "sheet.ngc", asked);
      EXPECT_EQ(faults_of(read.findings), "");
      ASSERT_TRUE(read.copies);
      EXPECT_EQ(read.copies->clean_parts, planned.copies->parts);
      EXPECT_EQ(read.copies->turned, planned.copies->turned);
    }
  }
  PlanOptions loose = in_grid(with({"endmill:4", "drill:4"}), "2x2", 12);
  loose.accept = {"loose-part"};
  const PlanResult cut_loose = plan_part(rounded_plate(), loose);
  const CheckResult missing = check_program(rounded_plate(), cut_loose.program, "sheet.ngc", grid);
  EXPECT_FALSE(missing.findings.faults.empty());
  EXPECT_EQ(missing.copies->clean_parts, 0);
  // Kerfs that meet leave nothing between parts that a tab could hold to.
  PlanOptions near = grid;
  near.copies.gap = 7;
  const PlanResult together = plan_part(rounded_plate(), near);
  EXPECT_THAT(conditions_named(together.findings), HasSubstr("loose-part"));
  const CheckResult read = check_program(rounded_plate(), together.program, "sheet.ngc", near);
  EXPECT_EQ(conditions_named(read.findings), conditions_named(together.findings));
  EXPECT_EQ(faults_of(read.findings), "");
  near.copies.gap.reset();
  EXPECT_GE(plan_part(rounded_plate(), near).copies->gap, 8.1);
  grid.tabs.count = 0;
  grid.tabs.at = {{30, 0}};
  EXPECT_THROW(check_program(rounded_plate(), cut_loose.program, "sheet.ngc", grid), InputError);
}

std::vector<Move> feed_moves(const Toolpath& toolpath) {
  std::vector<Move> moves;
  for (const Section& section : toolpath.sections)
    for (const Move& move : section.moves)
      if (!is_rapid(move.kind)) moves.push_back(move);
  return moves;
}

/// What copies have in common is written once: the control cuts as it does without.
TEST(Copies, SubprogramsMakeTheSameMoves) {
  for (const auto& [dialect, call] :
       {std::pair("linuxcnc", "o7001 call"), std::pair("tormach", "o7001 call"),
        std::pair("fanuc", "M98 P7001"), std::pair("haas", "M97 P7001"), std::pair("mach3", "M98 P7001"),
        std::pair("mach4", "M98 P7001"), std::pair("heidenhain", "CALL LBL 1"),
        std::pair("siemens", "REPEAT COPY7001 COPY7001_END")}) {
    SCOPED_TRACE(dialect);
    PlanOptions options = in_grid(with({"endmill:6", "drill:5"}), "3x1", 4);
    options.post.dialect = dialect;
    options.accept = {"blending"};
    const PlanResult plain = plan_part(plate(), options);
    options.copies.subprograms = true;
    const PlanResult called = plan_part(plate(), options);
    EXPECT_TRUE(called.findings.faults.empty()) << faults_of(called.findings);
    EXPECT_EQ(verdict_of(called.findings), verdict_of(plain.findings));
    EXPECT_EQ(called.copies->clean_parts, 3);
    EXPECT_THAT(called.program, HasSubstr(call));
    EXPECT_LT(called.program.size(), plain.program.size());
    const std::vector<Move> one = feed_moves(plain.toolpath), other = feed_moves(called.toolpath);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
      EXPECT_NEAR(distance(one[k].path.to, other[k].path.to), 0, 2e-3) << k;
      EXPECT_NEAR(one[k].z_to, other[k].z_to, 1e-3) << k;
      EXPECT_EQ(one[k].feed, other[k].feed) << k;
    }
  }
}

/// More by hand: CLEARCUT_RANDOM_PARTS=200.
int random_sheets() {
  const char* const asked = std::getenv("CLEARCUT_RANDOM_PARTS");
  return asked ? std::max(1, std::atoi(asked) / 10) : 2;
}

/// Pockets of random sizes, in rows or turned on a sheet, in mm or inches.
TEST(Copies, SubprogramsOfRandomPartsMakeTheSameMoves) {
  Random random(311);
  for (int round = 0; round < random_sheets(); ++round) {
    const double width = random.between(24, 60), height = random.between(20, 40);
    const Part part = drawn(
        box("STOCK_D8", 0, 0, width, height) +
        rounded_box("POCKET_D4", 4, 4, width - random.between(4, 9), height - random.between(4, 7), 3.5));
    for (const char* dialect :
         {"linuxcnc", "tormach", "fanuc", "haas", "mach3", "mach4", "heidenhain", "siemens"}) {
      SCOPED_TRACE(dialect + std::to_string(round));
      PlanOptions options = with({"endmill:5"});
      options.post.dialect = dialect;
      options.post.inch = random.unit() < 0.3;
      options.copies.gap = random.between(2, 9);
      if (random.unit() < 0.5)
        options.copies.grid = "2x2";
      else
        options.copies.sheet = fmt::format("{}x{}", width * 2 + 30, width + height + 40);
      const PlanResult plain = plan_part(part, options);
      options.copies.subprograms = true;
      const PlanResult called = plan_part(part, options);
      EXPECT_EQ(faults_of(called.findings), "");
      const std::vector<Move> one = feed_moves(plain.toolpath), other = feed_moves(called.toolpath);
      ASSERT_EQ(one.size(), other.size());
      for (std::size_t k = 0; k < one.size(); ++k) {
        ASSERT_LE(distance(one[k].path.to, other[k].path.to), 4e-3) << k;
        ASSERT_EQ(one[k].path.turn, other[k].path.turn) << k;
        ASSERT_NEAR(one[k].z_to, other[k].z_to, 1e-3) << k;
      }
    }
  }
}

TEST(Copies, SubprogramsThatNothingCallsAreRefused) {
  const auto refusal = [](const Part& part, const std::string& counts, const std::string& dialect) {
    PlanOptions options = in_grid(with({"endmill:6", "drill:5"}), counts, 4);
    options.post.dialect = dialect;
    options.copies.subprograms = true;
    try {
      plan_part(part, options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no refusal");
  };
  EXPECT_THAT(refusal(plate(), "2x1", "grbl"), HasSubstr("grbl has none that stand in the program itself"));
  EXPECT_THAT(refusal(plate(), "1x1", "fanuc"), HasSubstr("has no effect"));
  EXPECT_THAT(
      refusal(drawn(box("STOCK_D8", 0, 0, 40, 30) + circle("DRILL_D8", {32, 8}, 2.5)), "2x1", "fanuc"),
      HasSubstr("has no effect"));
  PlanOptions options = with({"endmill:6", "drill:5"});
  options.copies.subprograms = true;
  EXPECT_THROW(plan_part(plate(), options), InputError);
}

TEST(Copies, WhatIsNoNumberOfCopiesIsRefused) {
  for (const char* text : {"", "3", "0x2", "3x", "x3", "3x-1", "3x2x2", "99999x99999"})
    EXPECT_FALSE(counts_of_copies(text)) << text;
  for (const char* text : {"", "600", "x400", "600x", "-600x400", "0x400"})
    EXPECT_FALSE(size_of_sheet(text)) << text;
  EXPECT_EQ(counts_of_copies("3x2"), std::pair(3, 2));
  EXPECT_EQ(size_of_sheet("600x40cm"), std::pair(600.0, 400.0));
}

/// Options of copies that serve nothing, or contradict each other.
TEST(Copies, WhatServesNothingIsRefused) {
  const auto refused = [](const CopiesOptions& copies, const char* what) {
    PlanOptions options = with({"endmill:6", "drill:5"});
    options.copies = copies;
    try {
      plan_part(plate(), options);
      ADD_FAILURE() << "no refusal: " << what;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(what));
    }
  };
  refused({.gap = 4}, "--gap: lies between copies");
  refused({.grid = "2x1", .edge = 4}, "--edge: is of a sheet");
  refused({.grid = "2x1", .count = 4}, "--count: is of a sheet");
  refused({.grid = "2x1", .sheet = "200x100"}, "leave one of them out");
  PlanOptions options = in_grid(with({"endmill:6", "drill:5"}), "2x1", {});
  EXPECT_THROW(check_program(plate(), "G0 Z5", "a.ngc", options), InputError);
  EXPECT_THROW(check_program_alone({}, "G0 Z5", "a.ngc", options), InputError);
}

}  // namespace
}  // namespace clearcut::pipeline
