#include "plan/adaptive/smooth_links.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "base/units.h"
#include "plan/adaptive/adaptive.h"

namespace clearcut::plan::adaptive {
namespace {

void expect_tangential(const Path& path, const LinkEnd& from, const LinkEnd& to) {
  EXPECT_EQ(path.front().from, from.point);
  EXPECT_EQ(path.back().to, to.point);
  if (from.radius > 0) {
    EXPECT_LT(norm(path.front().tangent_at(0) - from.heading), 1e-6);
  }
  if (to.radius > 0) {
    EXPECT_LT(norm(path.back().tangent_at(1) - to.heading), 1e-6);
  }
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_EQ(path[i].from, path[i - 1].to);
    EXPECT_LT(norm(path[i].tangent_at(0) - path[i - 1].tangent_at(1)), 1e-6);
  }
}

TEST(SmoothLinks, LinkRunsAlongTheTangentsOfBothCuts) {
  Random random(3);
  int found = 0;
  for (int i = 0; i < 500; ++i) {
    const auto end = [&](Vec2 p) {
      return LinkEnd{p, direction_of(random.between(0, 2 * kPi)), random.between(0.1, 3),
                     random.between(0, 1) < 0.5};
    };
    LinkEnd from = end({0, 0}), to = end({random.between(-9, 9), random.between(-9, 9)});
    if (i % 5 == 0) from.radius = 0;
    if (i % 5 == 1) to.radius = 0;
    const auto path = smooth_link(from, to);
    if (!path) continue;
    ++found;
    expect_tangential(*path, from, to);
    if (const auto arcs = biarc(from.point, from.heading, to.point, to.heading)) {
      from.radius = to.radius = 1;
      expect_tangential(*arcs, from, to);
    }
  }
  EXPECT_GT(found, 250);
}

struct MachineCase {
  double feed, rapid, acceleration;
  MotionPlanner planner;
};
constexpr MachineCase kMachines[] = {{1000, 5000, 500, MotionPlanner::kLinuxCnc},
                                     {3000, 5000, 500, MotionPlanner::kLinuxCnc},
                                     {3000, 10000, 2000, MotionPlanner::kLinuxCnc},
                                     {3000, 5000, 500, MotionPlanner::kGrbl}};

MachineClock clock_of(const MachineCase& row) {
  MachineClock clock;
  clock.feed = MmPerMin::of(row.feed);
  clock.link_feed = clock.machine.rapid = MmPerMin::of(row.rapid);
  clock.machine.acceleration = row.acceleration;
  clock.path = {PathMode::kTolerance, 5e-4, std::nullopt};
  clock.of_control = row.planner;
  return clock;
}

double seconds_of(const LayerPasses& layer, const MachineClock& clock) {
  double sum = 0;
  for (const Pass& pass : layer.passes) sum += clock.seconds(pass.path, pass.kinds);
  return sum;
}

TEST(SmoothLinks, MachinesAreFasterOnWhatIsPlannedForThem) {
  const std::vector<std::vector<Vec2>> outlines = {
      {{0, 0}, {50, 0}, {50, 50}, {0, 50}},
      {{0, 0}, {60, 0}, {60, 8}, {8, 8}, {8, 42}, {60, 42}, {60, 50}, {0, 50}},
      {{0, 0}, {80, 0}, {55, 25}, {70, 60}, {30, 40}, {-5, 45}}};
  for (const auto& outline : outlines) {
    Layer layer;
    layer.z = -2;
    layer.tool_radius = 3;
    layer.allowed = layer.target = {Region::from_valid_loops(loop_from_points(outline), {})};
    const LayerPasses plain = plan_adaptive(layer, {}, {});
    for (const MachineCase& row : kMachines) {
      AdaptiveOptions options;
      options.clock = clock_of(row);
      const double before = seconds_of(plain, options.clock),
                   after = seconds_of(plan_adaptive(layer, options, {}), options.clock);
      EXPECT_LE(after, before * 1.0005) << row.feed << " " << row.acceleration;
      const bool is_slowed_most = row.planner == MotionPlanner::kLinuxCnc && row.feed == 3000;
      if (is_slowed_most) {
        EXPECT_LT(after, 0.99 * before);
      }
    }
  }
}

}  // namespace
}  // namespace clearcut::plan::adaptive
