// Random pockets with the widest cutter that goes in at all: a plunge or a few micrometres of way, never skipped.
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random.h"
#include "pipeline/prepare.h"
#include "pipeline/run.h"

namespace clearcut {
namespace {

Part random_pocket(int seed) {
  Random random(static_cast<std::uint64_t>(seed));
  const int corners = 3 + static_cast<int>(random.below(8));
  std::vector<BulgeVertex> outline;
  for (int i = 0; i < corners; ++i) {
    const double t = 2 * kPi * i / corners + random.between(-0.2, 0.2);
    const Vec2 p = direction_of(t) * random.between(15, 30);
    outline.push_back({p, random.below(3) == 0 ? random.between(-0.2, 0.3) : 0});
  }
  Feature feature;
  feature.name = "POCKET";
  feature.target = feature.allowed = {Region::from_valid_loops(loop_from_bulges(outline), {})};
  feature.floor_z = -2;
  Part part;
  part.name = part.source_file = "random";
  part.features = {feature};
  part.workplan.push_back({});
  return part;
}

PlanOptions with_diameter(double diameter) {
  Tool tool;
  tool.diameter = diameter;
  PlanOptions options;
  options.tools = {tool};
  return options;
}

TEST(ExactFit, TheWidestCutterIsPlannedCleanAndAWiderOneRefused) {
  for (int seed = 0; seed < 30; ++seed) {
    const Part part = random_pocket(seed);
    const double widest = largest_fitting_diameter(part.features[0], {});
    for (const double over : {-0.0004, 0.0, 0.0006}) {
      const auto result = plan(part, with_diameter(widest + over));
      EXPECT_TRUE(result.findings.all.clean) << seed << " over by " << over;
    }
    EXPECT_THROW(plan(part, with_diameter(widest + 0.01)), InputError) << seed;
  }
}

}  // namespace
}  // namespace clearcut
