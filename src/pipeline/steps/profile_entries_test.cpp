// Profiles where there is little room: acute corners, in which the kerfs of two sides run into each other, tabs near them and on
// arcs, and ways down along arcs.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "pipeline/run.h"
#include "pipeline/test_drawings.h"
#include "read/job/read_part.h"

namespace clearcut::pipeline {
namespace {

struct Cut {
  const char* name;
  const char* layer;
  std::vector<BulgeVertex> outline;
  const char* tool;
  int tabs = 0;
  EntryKind entry = EntryKind::kRamp;
  double lead = 0;
  bool finish = false;
  double stepdown = 0;
  double tab_height = 0;
};

PlanOptions options_of(const Cut& cut) {
  PlanOptions options;
  options.tools = {resolve::parse_tool(cut.tool)};
  options.strategy = "contour";
  options.tabs.count = cut.tabs;
  if (cut.tab_height > 0) options.tabs.height = cut.tab_height;
  options.entry = cut.entry;
  if (cut.lead > 0) options.lead = cut.lead;
  if (cut.finish) options.shop.finish = "walls";
  if (cut.stepdown > 0) options.stepdown = cut.stepdown;
  options.accept = {"out-of-reach"};
  return options;
}

class TightProfiles : public ::testing::TestWithParam<Cut> {};

TEST_P(TightProfiles, AreClean) {
  const Cut& cut = GetParam();
  const Part part =
      read::read_part_text(drawing(outline(cut.layer, cut.outline)), "profile.dxf", ReadOptions{});
  const auto result = plan_part(part, options_of(cut));
  for (const Fault& fault : result.findings.faults) ADD_FAILURE() << fault.text;
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean);
}

const Cut kCuts[] = {{"ATabIsNoDeeperThanItsKerf",
                      "INSIDE_D4",
                      {{{16.664, -3.505}}, {{-13.047, 14.889}}, {{-0.227, -24.6}}},
                      "endmill:4",
                      2},
                     {"ATabOnAnArcEndsWhereTheCutterTouchesIt",
                      "INSIDE_D4",
                      {{{17.128, 3.099}, -0.3963},
                       {{12.364, 14.31}, 0.1872},
                       {{-5.793, 26.558}, -0.1391},
                       {{-15.69, 15.106}},
                       {{-8.451, -1.371}},
                       {{-23.115, -15.25}, -0.1094},
                       {{3.756, -16.909}},
                       {{13.791, -21.177}, -0.3874}},
                      "endmill:6",
                      2},
                     {"ARampToAndFroFollowsAnArc",
                      "INSIDE_D6",
                      {{{12.846, 1.734}},
                       {{8.646, 13.137}},
                       {{-2.204, 10.715}, -0.3824},
                       {{-18.618, 14.138}},
                       {{-26.698, -2.857}, 0.085},
                       {{-12.324, -9.903}},
                       {{0.7, -17.268}, 0.198},
                       {{10.894, -8.037}}},
                      "endmill:2",
                      3,
                      EntryKind::kHelix},
                     {"ARampToAndFroStaysOnTheContour",
                      "PROFILE_D3",
                      {{{-14.387, 21.9}}, {{-21.912, -10.211}}, {{-4.897, -15.691}}},
                      "endmill:6",
                      2,
                      EntryKind::kZigzagRamp,
                      0,
                      false,
                      1.7},
                     {"ALeadDoesNotBeginWhereNoLayerAboveWasCut",
                      "INSIDE_D6",
                      {{{7.952, -1.254}}, {{1.588, 15.463}}, {{-19.003, -6.309}}, {{-1.151, -12.924}}},
                      "endmill:6",
                      1,
                      EntryKind::kRamp,
                      1,
                      false,
                      0,
                      0.5},
                     {"ALeadOfAFinishingPassDoesNeither",
                      "INSIDE_D4",
                      {{{26.083, -9.243}}, {{-13.964, 15.374}}, {{-11, -16.343}}},
                      "endmill:3",
                      3,
                      EntryKind::kHelix,
                      1,
                      true},
                     {"ALeadBeginsWhereTheSlotWasCut",
                      "PROFILE_D6",
                      {{{5, 0}},
                       {{31, 0}, 0.4142},
                       {{36, 5}},
                       {{36, 25}, 0.4142},
                       {{31, 30}},
                       {{5, 30}, 0.4142},
                       {{0, 25}},
                       {{0, 5}, 0.4142}},
                      "endmill:4:noplunge",
                      2,
                      EntryKind::kZigzagRamp,
                      1,
                      true},
                     {"WhereNothingWasCutBeforeTheCutterRampsAlongTheWall",
                      "POCKET_D2.5",
                      {{{0, 0}}, {{5.5, 0}}, {{5.5, 20}}, {{0, 20}}},
                      "endmill:5:noplunge",
                      0,
                      EntryKind::kPlunge,
                      0,
                      true}};

INSTANTIATE_TEST_SUITE_P(Profiles, TightProfiles, ::testing::ValuesIn(kCuts),
                         [](const auto& cut) { return cut.param.name; });

}  // namespace
}  // namespace clearcut::pipeline
