// Leaning walls that two cutters make one after the other: their layers have to meet, or no wall is ever cleared as a whole.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/random.h"
#include "pipeline/run.h"
#include "pipeline/test_drawings.h"
#include "plan/common/layers.h"
#include "read/job/read_part.h"

namespace clearcut::pipeline {
namespace {

Part leaning_pocket(double depth, double lean, double fillet = 0) {
  return read::read_part_text(
      fmt::format(R"({{"units": "mm", "pockets": [{{"name": "P", "top": 0, "depth": {}, "slope_rad": {},
                       "floor_fillet": {}, "outer": [[0, 0], [19, 2], [16, 15], [1, 13]]}}]}})",
                  depth, lean, fillet),
      "leaning.json", {});
}

struct TwoCutters {
  double depth, lean, fillet;
  const char *first, *second;
  bool rest;
  const char* finish;
};

TEST(LeaningRest, WallsThatTwoCuttersMakeAreCleanWhereverTheirLayersLie) {
  const TwoCutters cases[] = {
      {4, 0.19, 0, "endmill:8", "bullnose:3:corner=0.2", true, ""},
      {7, 0.05, 0, "endmill:8", "ball:3", true, ""},
      {4, 0.1, 0, "endmill:8", "bullnose:3:corner=1", true, ""},
      {4, 0.35, 0, "endmill:8", "bullnose:3:corner=0.2", true, ""},
      {4, 0.35, 2, "endmill:4", "ball:4", false, "walls"},
      {3, 0.6, 0, "endmill:8", "ball:3", true, ""},
  };
  for (const TwoCutters& one : cases) {
    PlanOptions options = with({one.first, one.second});
    options.shop.rest = one.rest;
    if (*one.finish) options.shop.finish = one.finish;
    options.strategy = "contour";
    options.accept = {"out-of-reach"};
    const PlanResult plan = plan_part(leaning_pocket(one.depth, one.lean, one.fillet), options);
    EXPECT_TRUE(plan.findings.faults.empty()) << one.lean << " " << one.second << "\n"
                                              << faults_of(plan.findings);
  }
}

/// Whether z lies between two of the heights, or the top at 0, that are farther apart than a step.
bool is_in_wider_gap(double z, const std::vector<double>& heights, double step) {
  double above = 0;
  for (const double below : heights) {
    if (z < above && z > below) return above - below > step;
    above = below;
  }
  return false;
}

TEST(LeaningRest, HeightsAreThoseOfOthersButWhereTheseAreFartherApart) {
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    Feature feature;
    feature.top_z = 0;
    feature.floor_z = -random.between(0.5, 8);
    Operation earlier, own;
    earlier.stepdown = random.between(0.3, 4);
    own.stepdown = random.between(0.3, 4);
    const std::vector<double> others = plan::heights_of(feature, earlier, 2, {}, 0);
    const std::vector<double> heights = plan::heights_of(feature, own, 2, {}, 0, others);
    EXPECT_EQ(heights.back(), feature.floor_z);
    double above = 0;
    for (const double z : heights) {
      EXPECT_LT(z, above);
      EXPECT_LE(above - z, *own.stepdown * 1.05 + 1e-9);  // thin slivers are shared out
      const bool is_shared = std::find(others.begin(), others.end(), z) != others.end();
      EXPECT_TRUE(is_shared || is_in_wider_gap(z, others, *own.stepdown)) << z;
      above = z;
    }
  }
}

}  // namespace
}  // namespace clearcut::pipeline
