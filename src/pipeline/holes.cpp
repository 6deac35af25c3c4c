#include "pipeline/holes.h"

#include "link/hole.h"
#include "pipeline/certify.h"
#include "stock/round_hole.h"

namespace clearcut::pipeline {
namespace {

link::HoleWork work_of(const stock::RoundHole& hole, const std::vector<Layer>& layers) {
  return {hole.center, hole.radius - layers.back().wall_stock, layers.front().z_top, layers.back().z};
}

bool is_drilled(const stock::RoundHole& hole, const Workingstep& step, const Tool& tool,
                const resolve::PlanOptions& options) {
  if (stock::only_plunges(tool)) return tool.radius() <= hole.radius + options.tol.fit;
  return tool.center_cutting && step.operation.allowance_side == 0 &&
         stock::makes_hole(tool, hole, options.tol);
}

bool is_bored(const link::HoleWork& work, const Feature& feature, const Workingstep& step, const Tool& tool,
              const resolve::PlanOptions& options) {
  return options.strategy == "auto" && feature.kind == FeatureKind::kRoundHole &&
         step.operation.entry != EntryKind::kPlunge && link::can_bore(work, tool.radius());
}

}  // namespace

std::optional<Section> hole_step(const std::vector<Layer>& layers, int workingstep, const Part& part,
                                 const resolve::PlanOptions& options) {
  const auto& step = part.workplan.at(static_cast<std::size_t>(workingstep));
  const auto& feature = feature_of(part, step);
  const auto& tool = tool_of(part, step);
  const auto hole = stock::round_hole_of(feature, options.tol);
  std::optional<Section> section;
  if (hole && !layers.empty()) {
    const link::HoleWork work = work_of(*hole, layers);
    const link::LinkOptions link = link_options(part, workingstep, EntryKind::kHelix, options);
    if (is_drilled(*hole, step, tool, options)) {
      section = link::drill_hole(work, *step.operation.stepdown, link);
    } else if (is_bored(work, feature, step, tool, options)) {
      section = link::bore_hole(work, *step.operation.stepdown, link);
    }
  }
  if (!section && stock::only_plunges(tool)) section = Section{};
  if (section) describe(*section, workingstep, part);
  return section;
}

}  // namespace clearcut::pipeline
