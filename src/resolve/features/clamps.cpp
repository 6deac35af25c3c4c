#include "resolve/features/clamps.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "geometry/contours/boolean.h"

namespace clearcut::resolve {
namespace {

/// mm2. Smaller overlaps are due to rounding.
constexpr double kTouching = 0.01;

Regions plan_of(const KeepOut& block) {
  return {Region::from_valid_loops(rectangle(block.plan), {})};
}

/// Whether a cutter at the floor of the feature may meet the block: its shank reaches up beside the block.
bool is_near(const KeepOut& block, const Feature& feature, const Regions& area) {
  return block.top_z > feature.floor_z + kSamePlaceMm && !area.empty() && box(area).overlaps(block.plan);
}

/// The block, wider by the shank's or the holder's reach beyond the cutter where these come down beside it.
KeepOut widened(const KeepOut& block, const Tool& tool, double floor) {
  double reach = 0;
  if (tool.flute_length && block.top_z > floor + *tool.flute_length)
    reach = std::max(reach, tool.shank_diameter / 2 - tool.radius());
  if (tool.stickout && block.top_z > floor + *tool.stickout)
    reach = std::max(reach, tool.holder_diameter / 2 - tool.radius());
  return {block.plan.grown(reach), block.bottom_z, block.top_z};
}

}  // namespace

void keep_out_of_clamps(Part& part, const Tolerances& tol) {
  for (const Workingstep& step : part.workplan) {
    Feature& feature = part.features[static_cast<std::size_t>(step.feature)];
    for (const KeepOut& block : part.keep_outs) {
      const KeepOut wide = widened(block, tool_of(part, step), feature.floor_z);
      if (is_near(wide, feature, feature.allowed))
        feature.allowed = subtract(feature.allowed, plan_of(wide), tol);
    }
  }
}

void refuse_under_clamps(const Part& part, const Workingstep& step) {
  const Feature& feature = feature_of(part, step);
  for (const KeepOut& block : part.keep_outs) {
    if (!is_near(block, feature, feature.target)) continue;
    const double under = area(intersect(feature.target, plan_of(block), Tolerances{}));
    if (under < kTouching) continue;
    throw InputError(
        feature.name,
        fmt::format("the clamp at x {} to {}, y {} to {} stands on {} mm2 of it, up to z {}; move "
                    "the clamp, or cut this in a set-up of its own",
                    trimmed(block.plan.min.x, 3), trimmed(block.plan.max.x, 3), trimmed(block.plan.min.y, 3),
                    trimmed(block.plan.max.y, 3), trimmed(under, 2), trimmed(block.top_z, 3)));
  }
}

}  // namespace clearcut::resolve
