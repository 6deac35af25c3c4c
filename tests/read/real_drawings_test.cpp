// Drawings as people publish them, planned and certified.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "base/file.h"
#include "pipeline/run.h"
#include "read/job/read_part.h"
#include "support/data.h"
#include "support/drawings.h"

namespace clearcut {
namespace {

/// Whether the plan said that the cutter does not fit the feature.
bool is_refused(const Part& part, const std::string& feature) {
  const auto& items = part.diagnostics.items();
  return std::any_of(items.begin(), items.end(), [&](const Diagnostic& item) {
    return item.what.find("does not fit " + feature + ";") != std::string::npos;
  });
}

/// Every pocket is clean, or refused by name.
void expect_clean_or_refused(const std::string& text, const std::string& file, double diameter) {
  SCOPED_TRACE(file + " with " + std::to_string(diameter));
  ReadOptions read;
  read.depth = 2;
  PlanOptions options;
  options.tools = {resolve::parse_tool("endmill:" + std::to_string(diameter))};
  const auto result = pipeline::plan_part(read::read_part_text(text, file, read), options);
  EXPECT_GT(result.findings.all.feed_mm, 0);
  for (const auto& fault : result.findings.faults) {
    if (fault.kind == FaultKind::kNothingCut && is_refused(result.part, fault.feature)) continue;
    ADD_FAILURE() << fault.text;
  }
}

TEST(OwnDrawings, EveryPocketIsCleanOrRefusedByName) {
  expect_clean_or_refused(test_support::gear_with_gaps_dxf(), "gear.dxf", 1);
  expect_clean_or_refused(test_support::gear_with_gaps_dxf(), "gear.dxf", 3);
  expect_clean_or_refused(test_support::narrow_necks_dxf(), "necks.dxf", 2);
  expect_clean_or_refused(test_support::bulges_dxf(), "bulges.dxf", 6);
  expect_clean_or_refused(test_support::touching_squares_svg(), "touch.svg", 3);
  expect_clean_or_refused(test_support::traced_svg(), "trace.svg", 3);
}

/// Published drawings, where they are; they only add to the own ones.
TEST(RealDrawings, EveryPocketIsCleanOrRefusedByName) {
  const auto data = test_support::data_folder();
  if (!data) return;
  const auto expect_clean_or_refused = [&](const std::string& file, double diameter) {
    clearcut::expect_clean_or_refused(read_file((*data / "drawings" / file).string()), file, diameter);
  };
  expect_clean_or_refused("gear-endpoint-gaps.dxf", 1);
  expect_clean_or_refused("gear-endpoint-gaps.dxf", 3);  // no tooth is wide enough
  expect_clean_or_refused("vslot-narrow-necks.dxf", 2);
  expect_clean_or_refused("bulge-polylines.dxf", 6);
  expect_clean_or_refused("touching-contours-88.svg", 3);
  expect_clean_or_refused("rabbit-trace.svg", 3);
}

/// The plate of tests/plan/holes_test.cpp is ours; published samples are added where they are.
TEST(RealParts, EverySampleOfStepNcIsCleanWithCuttersThatFit) {
  const auto data = test_support::data_folder();
  if (!data) return;
  const std::string folder = data->string() + "/stepnc/";
  for (const char* name : {"unb_final_test.p21", "ufsc_hole_slot_step_pocket.p21", "ufsc_slot_rounded_u.p21",
                           "iso14649_11_ex1.stp", "iso14649_11_ex1_nist.stp"}) {
    PlanOptions options;
    // It asks for a ball end mill on a flat floor.
    if (std::string(name) == "unb_final_test.p21")
      options.tools = {resolve::parse_tool("endmill:4"), resolve::parse_tool("endmill:6")};
    Part part = read::read_part(folder + name, {});
    for (Tool& tool : part.tools) tool.flute_length.reset();  // some are stated shorter than they cut deep
    const auto result = pipeline::plan_part(part, options);
    for (const auto& fault : result.findings.faults) {
      // Centre drilling and a slot with a rounded bottom are not planned: said as features that are not machined.
      const bool asks_for_more =
          std::string(name) == "unb_final_test.p21" || std::string(name) == "ufsc_slot_rounded_u.p21";
      if (asks_for_more && fault.kind == FaultKind::kNothingCut) continue;
      ADD_FAILURE() << name << ": " << fault.text;
    }
  }
}

}  // namespace
}  // namespace clearcut
