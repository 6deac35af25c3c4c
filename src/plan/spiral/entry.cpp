#include "plan/spiral/entry.h"

#include "plan/common/layers.h"
#include "plan/contour/line_distance.h"
#include "plan/spiral/spiral.h"
#include "plan/spiral/turn.h"

namespace clearcut::plan::spiral {
namespace {

Strategy make(const StrategyRequest& request) {
  SpiralOptions options;
  options.wall_on_right = request.step.wall_on_right();
  options.machine = request.plan.machine;
  options.feed = request.step.feed;
  line_distance(request.stepover,
                1);  // throws for rules without meaning for spirals, before planning begins
  return once_per_outline(
      [options, stepover = request.stepover, tol = request.plan.tol](const Layer& layer) mutable {
        options.stepover = line_distance(stepover, 2 * layer.tool_radius);
        return plan_spiral(layer, options, tol);
      });
}

double least_length(const ClearedSize& size, double radius) {
  return size.reached_mm2 / (2 * radius) + kSpiralFall * size.legal_rim_mm / 2;
}

}  // namespace

StrategyEntry entry() {
  StrategyEntry entry;
  entry.name = "spiral";
  entry.description = "smooth turns from contour to contour, without passages";
  entry.make = make;
  entry.in_auto = AutoUse::kTried;
  entry.least_length = least_length;
  // Factor on its least time; in 120 random pockets spirals took 1.17 to 2 times the least time.
  entry.margin = 1.15;
  return entry;
}

}  // namespace clearcut::plan::spiral
