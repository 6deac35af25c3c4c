#include "plan/adaptive/entry.h"

#include <utility>

#include "base/elementary.h"
#include "plan/adaptive/adaptive.h"
#include "plan/common/layers.h"

namespace clearcut::plan::adaptive {
namespace {

Strategy make(const StrategyRequest& request, const ClockOf& clock_of) {
  AdaptiveOptions options;
  options.clock = clock_of(request);
  if (request.step.aimed_engagement_deg)
    options.engagement = Radians::of_degrees(*request.step.aimed_engagement_deg);
  if (request.plan.engagement_deg) options.engagement = Radians::of_degrees(*request.plan.engagement_deg);
  options.start = request.plan.start;
  options.cancel = request.plan.cancel;
  options.widest_helix = request.step.helix_widest;
  return once_per_outline(
      [options, tol = request.plan.tol](const Layer& layer) { return plan_adaptive(layer, options, tol); });
}

double least_length(const ClearedSize& size, double radius) {
  return size.reached_mm2 / (radius * (1 - base::cos(AdaptiveOptions{}.engagement.radians())));
}

}  // namespace

StrategyEntry entry(ClockOf clock_of) {
  StrategyEntry entry;
  entry.name = "adaptive";
  entry.description = "engagement limited, spiral and arcs";
  entry.make = [clock_of = std::move(clock_of)](const StrategyRequest& request) {
    return make(request, clock_of);
  };
  entry.in_auto = AutoUse::kTried;
  entry.limits_engagement = true;
  entry.takes_stepover = false;
  entry.least_length = least_length;
  return entry;
}

}  // namespace clearcut::plan::adaptive
