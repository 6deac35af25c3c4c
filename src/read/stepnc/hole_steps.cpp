// What hole-making operations work on: the hole itself, or one of their own where they go to another depth or width.
#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/text/format.h"
#include "read/stepnc/parts.h"
#include "read/stepnc/reader.h"

namespace clearcut::read::stepnc {

/// A length of overcut is for open sides: where there are none it asks for nothing.
void Reader::use_overcut(const Node& operation, const std::vector<std::size_t>& drafts) {
  if (operation.unset(8) || operation.number(8) == 0.0) return;
  const bool closed = std::all_of(drafts.begin(), drafts.end(), [&](std::size_t draft) {
    return closed_all_round(feature_of_draft(draft)) && !drafts_[draft].through;
  });
  if (closed)
    return context_.note("nothing is open where its overcut of " + trimmed(*operation.length(8), 3) +
                             " mm (overcut_length) would lead",
                         operation);
  context_.diagnostics.doubt(context_.file.place(operation.line()), kNotFollowed,
                             "not followed: the overcut of " + operation.label() + " beyond open sides, " +
                                 trimmed(*operation.length(8), 3) + " mm (overcut_length)");
}

std::vector<int> Reader::features_for(std::size_t draft, const StatedOperation& stated, const Node& node) {
  if (!goes_straight_down(stated.operation)) return features_of_draft_[draft];
  check_previous(draft, stated, node);
  return {hole_for(draft, stated, node)};
}

namespace {

/// Of a drill whose diameter lies in the field of the hole's the hole has that.
void fit_to_tool(Feature& feature, const Draft& draft, const Tool& tool) {
  const double off = tool.diameter - draft.hole.size;
  if (off == 0 || !makes_holes(tool) || off < -draft.hole.below - 1e-9 || off > draft.hole.above + 1e-9)
    return;
  const Vec2 c{draft.placement.origin.x, draft.placement.origin.y};
  const Vec2 r{tool.diameter / 2, 0};
  feature.hole_diameter = tool.diameter;
  feature.target =
      feature.allowed = {Region::from_valid_loops({Edge::arc(c + r, c - r, c, Turn::kCounterClockwise),
                                                   Edge::arc(c - r, c + r, c, Turn::kCounterClockwise)},
                                                  {})};
}

}  // namespace

int Reader::add_hole(const Feature& like, const Draft& draft, const std::string& name, double width,
                     double floor) {
  Feature hole = like;
  hole.name = unique_name(name);
  hole.kind = FeatureKind::kRoundHole;
  hole.floor_z = floor;
  hole.hole_diameter = width;
  hole.wall_slope = {};
  const Vec2 c{draft.placement.origin.x, draft.placement.origin.y};
  const Vec2 r{width / 2, 0};
  hole.target =
      hole.allowed = {Region::from_valid_loops({Edge::arc(c + r, c - r, c, Turn::kCounterClockwise),
                                                Edge::arc(c - r, c + r, c, Turn::kCounterClockwise)},
                                               {})};
  part_.features.push_back(std::move(hole));
  has_own_holes_ = true;
  return static_cast<int>(part_.features.size()) - 1;
}

/// The hole itself, or one of its own where the operation goes to another depth.
int Reader::hole_for(std::size_t index, const StatedOperation& stated, const Node& node) {
  const Draft& draft = drafts_[index];
  const Tool& tool = part_.tools[static_cast<std::size_t>(stated.operation.tool)];
  Feature& hole = feature_of_draft(index);
  const bool is_alone = !stated.depth && operations_on(draft.node) < 2;
  if (stated.hole == HoleKind::kSpotted && !is_alone) return spot_for(draft, hole, stated, node);
  if (stated.hole == HoleKind::kCountersunk) return countersink_for(draft, hole, stated, node);
  fit_to_tool(hole, draft, tool);
  const double full = hole.top_z - hole.floor_z;
  const double depth = stated.depth.value_or(full);
  if (std::abs(depth - full) < kLevel) return features_of_draft_[index].back();
  if (depth > full && !hole.through)
    context_.diagnostics.doubt(context_.file.place(node.line()), kNotFollowed,
                               "not followed: " + node.label() + " goes " + trimmed(depth, 3) +
                                   " mm deep (cutting_depth) and " + hole.name + " is " + trimmed(full, 3) +
                                   " mm deep; it is made no deeper");
  if (depth > full && !hole.through) return features_of_draft_[index].back();
  const bool is_narrower = makes_holes(tool) && tool.diameter < *hole.hole_diameter - context_.tol.fit;
  if (depth > full && !is_narrower) {
    hole.floor_z = hole.top_z - depth;  // all its steps may go as far: it goes through
    return features_of_draft_[index].back();
  }
  const Feature like = hole;
  return add_hole(like, draft, like.name + " to " + trimmed(depth, 3) + " mm",
                  is_narrower ? tool.diameter : *like.hole_diameter, like.top_z - depth);
}

/// How many workingsteps work on a feature.
std::size_t Reader::operations_on(const Node& feature) const {
  const auto is_on = [&](const OrderedStep& step) {
    const auto own = step.node.sound_ref(2);
    return own && own->id() == feature.id();
  };
  return static_cast<std::size_t>(std::count_if(program_.steps.begin(), program_.steps.end(), is_on));
}

/// Of no stated depth: the point of the drill.
int Reader::spot_for(const Draft& draft, const Feature& hole, const StatedOperation& stated,
                     const Node& node) {
  const Tool& tool = part_.tools[static_cast<std::size_t>(stated.operation.tool)];
  if (tool.diameter > *hole.hole_diameter + context_.tol.fit)
    node.fail("the centre drill of " + trimmed(tool.diameter, 3) + " mm is wider than the hole of " +
              trimmed(*hole.hole_diameter, 3) + " mm and would break its edge; give one no wider");
  const double depth = stated.depth.value_or(std::max(point_length(tool), 0.1 * tool.diameter));
  if (depth > hole.top_z - hole.floor_z + kLevel && !hole.through)
    node.fail("it goes " + trimmed(depth, 3) + " mm deep and the hole is " +
              trimmed(hole.top_z - hole.floor_z, 3) + " mm deep; correct cutting_depth");
  const Feature like = hole;
  return add_hole(like, draft, like.name + " centre", tool.diameter, like.top_z - depth);
}

int Reader::countersink_for(const Draft& draft, const Feature& hole, const StatedOperation& stated,
                            const Node& node) {
  const Tool& tool = part_.tools[static_cast<std::size_t>(stated.operation.tool)];
  if (!is_conical(tool)) node.fail("countersinking needs a COUNTERSINK with its angle; give one");
  double width = draft.hole.size;
  if (draft.hole_diameter) {
    if (!stated.depth) node.fail("no cutting_depth says how wide the countersink is; give one");
    width += 2 * *stated.depth * flank_slope(tool);
  }
  if (width > tool.diameter + context_.tol.fit)
    node.fail("the countersink is " + trimmed(width, 3) + " mm wide and its tool " +
              trimmed(tool.diameter, 3) + " mm; give a wider one");
  const Feature like = hole;
  const int index = add_hole(like, draft, like.name + " countersink", width, like.floor_z);
  HoleForm form;
  form.kind = HoleKind::kCountersunk;
  form.center = {draft.placement.origin.x, draft.placement.origin.y};
  form.diameter = width;
  form.full_z = like.top_z;
  part_.features[static_cast<std::size_t>(index)].hole = form;
  return index;
}

/// A hole that is to be there before has to be made by an earlier step.
void Reader::check_previous(std::size_t draft, const StatedOperation& stated, const Node& node) {
  if (!stated.previous_diameter) return;
  constexpr double kSamePrevious = 0.05;  // mm
  for (const std::size_t step : steps_of_draft_[draft])
    if (std::abs(tool_of_step(step).diameter - *stated.previous_diameter) < kSamePrevious) return;
  context_.diagnostics.doubt(context_.file.place(node.line()), kNotFollowed,
                             "no earlier workingstep makes the hole of " +
                                 trimmed(*stated.previous_diameter, 3) + " mm (previous_diameter) that " +
                                 node.label() + " begins in; it is there before");
}

}  // namespace clearcut::read::stepnc
