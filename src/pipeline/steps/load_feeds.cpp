#include "pipeline/steps/load_feeds.h"

#include <algorithm>

#include "link/sections/load_feeds.h"
#include "stock/cutter_sweep.h"
#include "stock/material.h"
#include "verify/program/load_reference.h"

namespace clearcut::pipeline {
namespace {

/// mm below every floor.
constexpr double kBelow = 1;

void take_away_holes(stock::Material& material, const Part& part) {
  double bottom = part.top_z();
  for (const Feature& feature : part.features) bottom = std::min(bottom, feature.floor_z);
  for (const PredrilledHole& hole : part.predrilled) {
    const Edge down = Edge::line(hole.center, hole.center);
    material.add({down, part.top_z(), bottom - kBelow, MoveKind::kPlunge, {}, 0}, hole.diameter / 2);
  }
}

}  // namespace

void take_away(stock::Material& material, const Section& section, const Tool& tool) {
  for (const Move& move : section.moves)
    if (!is_rapid(move.kind)) stock::remove_cut(material, move, tool);
}

stock::Material material_at_start(const Part& part, const std::optional<Toolpath>& earlier,
                                  std::vector<double> radii) {
  for (const PredrilledHole& hole : part.predrilled) radii.push_back(hole.diameter / 2);
  stock::Material material(part.stock ? std::optional(part.stock->plan) : std::nullopt, part.top_z(), radii);
  take_away_holes(material, part);
  if (!earlier) return material;
  for (const Section& section : earlier->sections) {
    // Material not known to be cut counts as present; this can only lower feeds.
    const Tool* const tool = tool_numbered(part.tools, section.tool_number);
    if (tool && section.counts_below(part.top_z())) take_away(material, section, *tool);
  }
  return material;
}

void follow_load(Toolpath& toolpath, const ResolvedPlan& plan) {
  if (!plan.feed_rule) return;
  const Part& part = plan.part;
  std::vector<double> radii;
  for (const Tool& tool : part.tools) radii.push_back(tool.radius());
  stock::Material material = material_at_start(part, plan.earlier, radii);
  verify::LoadReference reference{*plan.feed_rule};
  for (const ResolvedStep& step : plan.steps) reference.feed_of_step.push_back(step.feed);
  for (Section& section : toolpath.sections) {
    const Tool& tool = tool_of(part, part.workplan[static_cast<std::size_t>(section.workingstep)]);
    if (!mills_upright(tool)) {
      take_away(material, section, tool);
      continue;
    }
    MmPerMin cap = MmPerMin::of(reference.cap(section.workingstep, section.tool_number));
    if (plan.machine.max_feed && *plan.machine.max_feed < cap) cap = *plan.machine.max_feed;
    const ResolvedStep& step = plan.steps[static_cast<std::size_t>(section.workingstep)];
    link::set_load_feeds(
        section, tool,
        {*plan.feed_rule, MmPerMin::of(reference.feed(section.workingstep, section.tool_number)), cap,
         step.feed, plan.machine.acceleration, true},
        material);
  }
}

}  // namespace clearcut::pipeline
