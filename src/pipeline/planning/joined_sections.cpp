#include "pipeline/planning/joined_sections.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "link/sections/slot_feed.h"
#include "model/section_names.h"
#include "pipeline/selection/rapids_over_rests.h"
#include "pipeline/steps/load_feeds.h"
#include "pipeline/steps/section_order.h"
#include "post/post.h"
#include "stock/material.h"

namespace clearcut::pipeline {
namespace {

/// Whether links at depth are faster than cuts. (Within one stroke the planner knows the cut material.)
bool has_fast_links(const ResolvedStep& step, const ResolvedPlan& plan) {
  return plan.link_feed && step.feed < *plan.link_feed;
}

/// Slows down steps with a slot feed in full-width cuts, and fast links in any material, taking all earlier moves
/// into account.
void slow_down_slots(Toolpath& toolpath, const ResolvedPlan& plan) {
  const Part& part = plan.part;
  const auto step_of = [&](const Section& section) -> const ResolvedStep& {
    return plan.steps[static_cast<std::size_t>(section.workingstep)];
  };
  const bool wanted =
      std::any_of(toolpath.sections.begin(), toolpath.sections.end(), [&](const Section& section) {
        return step_of(section).slot_feed != step_of(section).feed || has_fast_links(step_of(section), plan);
      });
  if (!wanted) return;
  std::vector<double> radii;
  for (const auto& tool : part.tools) radii.push_back(tool.radius());
  stock::Material material(part.stock ? std::optional(part.stock->plan) : std::nullopt, part.top_z(), radii);
  for (auto& section : toolpath.sections) {
    const ResolvedStep& step = step_of(section);
    const Workingstep& work = part.workplan[static_cast<std::size_t>(section.workingstep)];
    Section slowed = section;
    link::slow_down_slots(slowed, tool_of(part, work), {plan.slot_angle, step.slot_feed, step.feed},
                          material);
    if (path_of(work) == nullptr) section = std::move(slowed);
  }
}

}  // namespace

Toolpath toolpath_of(const Selection& selection, const ResolvedPlan& plan, bool over_rests) {
  const Part& part = plan.part;
  Toolpath toolpath;
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    if (!selection.section(i).moves.empty()) toolpath.sections.push_back(selection.section(i));
  }
  if (part.order_free)
    toolpath.sections =
        in_short_order(std::move(toolpath.sections), part, post::repeats_cycles(plan.post.dialect));
  if (over_rests) keep_rapids_high(toolpath, plan);
  slow_down_slots(toolpath, plan);
  follow_load(toolpath, plan);
  const SectionNames names(part);
  for (Section& section : toolpath.sections) section.label = names.of(section.workingstep);
  return toolpath;
}

}  // namespace clearcut::pipeline
