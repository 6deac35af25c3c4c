#include "plan/zigzag/entry.h"

#include "plan/common/layers.h"
#include "plan/contour/line_distance.h"
#include "plan/zigzag/zigzag.h"

namespace clearcut::plan::zigzag {
namespace {

Strategy make(const StrategyRequest& request) {
  ZigzagOptions options;
  options.angle = request.step.stroke_angle;
  options.material_on_right = request.step.wall_on_right();
  options.machine = request.plan.machine;
  options.feed = request.step.feed;
  line_distance(request.stepover,
                1);  // throws for rules without meaning for lines, before planning begins
  return once_per_outline(
      [options, stepover = request.stepover, tol = request.plan.tol](const Layer& layer) mutable {
        options.stepover = line_distance(stepover, 2 * layer.tool_radius);
        return plan_zigzag(layer, options, tol);
      });
}

}  // namespace

StrategyEntry entry() {
  StrategyEntry entry;
  entry.name = "zigzag";
  entry.description = "parallel lines to and fro, then along the walls";
  entry.make = make;
  entry.keeps_direction = false;
  entry.in_auto = AutoUse::kTried;
  return entry;
}

}  // namespace clearcut::plan::zigzag
