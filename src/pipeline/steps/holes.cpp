#include "pipeline/steps/holes.h"

#include <algorithm>

#include "features/round_hole.h"
#include "link/hole.h"
#include "pipeline/steps/certify.h"
#include "plan/common/layers.h"

namespace clearcut::pipeline {
namespace {

link::HoleWork work_of(const features::RoundHole& hole, const std::vector<Layer>& layers) {
  return {hole.center, hole.radius - layers.back().wall_stock, layers.front().z_top, layers.back().z};
}

bool is_drilled(const features::RoundHole& hole, const ResolvedStep& step, const Tool& tool,
                const Tolerances& tol) {
  if (makes_holes(tool)) return tool.radius() <= hole.radius + tol.fit;
  return tool.center_cutting && step.allowance_side == 0 && features::makes_hole(tool, hole, tol);
}

/// Whether a layer was widened into features that remove some of the hole's wall: no stock may be left there.
bool runs_into_others(const std::vector<Layer>& layers, const Feature& feature) {
  return std::any_of(layers.begin(), layers.end(),
                     [&](const Layer& layer) { return !plan::same_outline(layer.allowed, feature.allowed); });
}

bool is_bored(const link::HoleWork& work, const Feature& feature, const ResolvedStep& step,
              const Tool& tool) {
  return step.strategy == nullptr && feature.kind == FeatureKind::kRoundHole && !step.is_plunge_asked &&
         link::can_bore(work, tool.radius());
}

}  // namespace

std::optional<Section> hole_step(const std::vector<Layer>& layers, int workingstep,
                                 const ResolvedPlan& plan) {
  const ResolvedStep& step = plan.steps.at(static_cast<std::size_t>(workingstep));
  const auto& planned = plan.part.workplan.at(static_cast<std::size_t>(workingstep));
  const auto& feature = feature_of(plan.part, planned);
  const auto& tool = tool_of(plan.part, planned);
  const auto hole = features::round_hole_of(feature, plan.tol);
  std::optional<Section> section;
  if (hole && !layers.empty()) {
    const link::HoleWork work = work_of(*hole, layers);
    const link::LinkOptions link = link_options(plan, workingstep, step.entry_at_limit);
    if (is_drilled(*hole, step, tool, plan.tol) &&
        !features::is_too_narrow_for_hole(plan.part, planned, plan.tol)) {
      const bool chips = feature.hole && feature.hole->chip_break;
      const bool feeds_out =
          tool.kind == ToolKind::kReamer ||
          (feature.hole && (feature.hole->kind == HoleKind::kReamed || tool.kind == ToolKind::kBoringBar));
      section = feeds_out ? link::feed_out_hole(work, link)
                : chips   ? link::chip_hole(work, step.stepdown, link)
                          : link::drill_hole(work, step.stepdown, link,
                                             planned.operation.hole_feeds.value_or(HoleFeeds{}));
    } else if (is_bored(work, feature, step, tool) && !runs_into_others(layers, feature)) {
      section = link::bore_hole(work, step.stepdown, link);
    }
  }
  if (!section && makes_holes(tool)) section = Section{};
  if (section) describe(*section, workingstep, plan);
  return section;
}

}  // namespace clearcut::pipeline
