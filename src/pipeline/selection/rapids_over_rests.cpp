#include "link/link.h"
#include "link/sections/high_rapids.h"
#include "pipeline/selection/selection.h"
#include "stock/cutting_load.h"

namespace clearcut::pipeline {
namespace {

stock::Material block_of(const Part& part) {
  std::vector<double> radii;
  for (const Tool& tool : part.tools) radii.push_back(widest_radius(tool));
  return {part.stock ? std::optional(part.stock->plan) : std::nullopt, part.top_z(), radii};
}

/// Removes the cuts of an earlier program on the same set-up.
void remove_earlier(const ResolvedPlan& plan, stock::Material& material) {
  if (!plan.earlier) return;
  for (const Section& section : plan.earlier->sections) {
    const Tool* const tool = tool_numbered(plan.part.tools, section.tool_number);
    if (section.carried_below || tool == nullptr) continue;
    for (const Move& move : section.moves) {
      if (!is_rapid(move.kind)) stock::remove_cut(material, move, *tool);
    }
  }
}

}  // namespace

void keep_rapids_high(Toolpath& toolpath, const ResolvedPlan& plan) {
  stock::Material material = block_of(plan.part);
  remove_earlier(plan, material);
  const link::LinkOptions defaults;
  for (Section& section : toolpath.sections) {
    const auto& step = plan.part.workplan[static_cast<std::size_t>(section.workingstep)];
    const Tool& tool = tool_of(plan.part, step);
    const MmPerMin plunge_feed = plan.steps[static_cast<std::size_t>(section.workingstep)].plunge_feed;
    Section higher = section;
    link::keep_rapids_high(higher, tool, {defaults.above_material, plunge_feed}, material);
    if (path_of(step) == nullptr) section = std::move(higher);
  }
}

}  // namespace clearcut::pipeline
