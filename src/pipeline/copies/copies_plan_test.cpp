// One part several times on one sheet: what the text of the one program makes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "base/random.h"
#include "pipeline/copies/copies.h"
#include "pipeline/copies/nest.h"
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

TEST(Copies, EachPartIsMadeAndEachToolComesOnce) {
  const resolve::PlanOptions options = with({"endmill:6", "drill:5"});
  const PlannedCopies sheet = plan_copies(plate(), options, parse_copies("3x2", 4));
  const PlanResult& result = sheet.result;
  EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings);
  EXPECT_EQ(sheet.parts, 6);
  EXPECT_EQ(sheet.clean_parts, 6);
  EXPECT_EQ(sheet.sheet.width(), 128);
  EXPECT_EQ(sheet.sheet.height(), 64);
  EXPECT_EQ(tool_changes(result.toolpath), 1U);
  std::set<std::string> names;
  for (const Feature& feature : result.part.features) names.insert(feature.name);
  EXPECT_EQ(names.size(), result.part.features.size());
  // One part's path six times.
  const PlanResult one = plan_part(plate(), options);
  EXPECT_NEAR(result.findings.all.feed_mm, 6 * one.findings.all.feed_mm, 0.01);
}

/// A program in which one copy is not cut is at fault for that part alone.
TEST(Copies, APartThatIsLeftOutIsMissed) {
  const resolve::PlanOptions options = with({"endmill:6", "drill:5"});
  const PlannedCopies sheet = plan_copies(plate(), options, parse_copies("2x1", 4));
  const Part part = sheet_of_copies(plate(), options, parse_copies("2x1", 4));
  const CheckResult whole = check_program(part, sheet.result.program, "sheet.ngc", options);
  EXPECT_TRUE(whole.findings.all.clean) << faults_of(whole.findings);
  const PlannedCopies one = plan_copies(plate(), options, parse_copies("1x1", 4));
  const CheckResult missing = check_program(part, one.result.program, "one.ngc", options);
  EXPECT_FALSE(missing.findings.faults.empty());
  for (const Fault& fault : missing.findings.faults) EXPECT_THAT(fault.feature, HasSubstr(".2"));
}

/// Parts that are cut out of a plain sheet stand a kerf apart.
TEST(Copies, CutOutsNeedTheKerf) {
  const Part part = drawn(box("STOCK_D3", -10, -10, 40, 30) + box("OUTSIDE_D3", 0, 0, 30, 20) +
                          circle("DRILL_D3", {10, 10}, 2));
  resolve::PlanOptions options = with({"endmill:4", "drill:4"});
  options.accept = {"loose-part"};
  try {
    plan_copies(part, options, parse_copies("2x2", 3));
    ADD_FAILURE() << "no refusal";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("3 mm between parts is less than the cutter needs"));
  }
  const PlannedCopies sheet = plan_copies(part, options, parse_copies("2x2", 10));
  EXPECT_TRUE(sheet.result.findings.faults.empty()) << faults_of(sheet.result.findings);
  EXPECT_EQ(sheet.clean_parts, 4);
  EXPECT_EQ(sheet.sheet.width(), 90);
  EXPECT_EQ(sheet.sheet.height(), 70);
}

/// Turned where that makes more parts; every part is certified where it lies.
TEST(Copies, ASheetIsFilledAndPartsAreTurned) {
  resolve::PlanOptions options = with({"endmill:6", "drill:5"});
  Sheet sheet = parse_sheet("125x74");
  sheet.gap = 2;
  sheet.edge = 1;
  const PlannedCopies planned = plan_copies(plate(), options, sheet);
  EXPECT_TRUE(planned.result.findings.all.clean) << faults_of(planned.result.findings);
  EXPECT_GT(planned.turned, 0);
  EXPECT_GT(planned.parts, planned.turned);
  EXPECT_EQ(planned.clean_parts, planned.parts);
  EXPECT_LE(planned.parts, *planned.at_most);
  const Part part = sheet_of_copies(plate(), options, sheet);
  const CheckResult read = check_program(part, planned.result.program, "sheet.ngc", options);
  EXPECT_TRUE(read.findings.all.clean) << faults_of(read.findings);
  sheet.count = 2;
  EXPECT_EQ(plan_copies(plate(), options, sheet).parts, 2);
  EXPECT_THROW(plan_copies(plate(), options, parse_sheet("30x20")), InputError);
}

/// Rectangles lie on the sheet, a gap apart, and no fewer than a plain grid has.
TEST(Nest, PlacesAreOnTheSheetAndApart) {
  Random random(7);
  for (int round = 0; round < 300; ++round) {
    NestQuestion q;
    q.width = random.between(20, 600);
    q.height = random.between(20, 400);
    q.edge = random.between(0, 8);
    q.gap = random.between(0, 10);
    q.part_width = random.between(8, 120);
    q.part_height = random.between(8, 120);
    const auto places = nest(q);
    const auto size = [&](const NestPlace& p) {
      return p.turned ? Vec2{q.part_height, q.part_width} : Vec2{q.part_width, q.part_height};
    };
    EXPECT_LE(static_cast<int>(places.size()), most_by_area(q));
    const auto along = [&](double length, double side) {
      return std::max(0.0, std::floor((length - 2 * q.edge + q.gap) / (side + q.gap)));
    };
    EXPECT_GE(static_cast<double>(places.size()),
              along(q.width, q.part_width) * along(q.height, q.part_height));
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Vec2 low = places[i].at, high = low + size(places[i]);
      EXPECT_TRUE(low.x >= q.edge - 1e-6 && low.y >= q.edge - 1e-6 && high.x <= q.width - q.edge + 1e-6 &&
                  high.y <= q.height - q.edge + 1e-6);
      for (std::size_t k = 0; k < i; ++k) {
        const Vec2 other = places[k].at, end = other + size(places[k]);
        EXPECT_TRUE(low.x >= end.x + q.gap - 1e-6 || other.x >= high.x + q.gap - 1e-6 ||
                    low.y >= end.y + q.gap - 1e-6 || other.y >= high.y + q.gap - 1e-6);
      }
    }
  }
}

TEST(Copies, WhatIsNoNumberOfCopiesIsRefused) {
  for (const char* text : {"", "3", "0x2", "3x", "x3", "3x-1", "3x2x2", "99999x99999"})
    EXPECT_THROW(parse_copies(text, 4), InputError) << text;
  EXPECT_THROW(parse_copies("3x2", -1), InputError);
  for (const char* text : {"", "600", "x400", "600x", "-600x400", "0x400"})
    EXPECT_THROW(parse_sheet(text), InputError) << text;
}

}  // namespace
}  // namespace clearcut::pipeline
