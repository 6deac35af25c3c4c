// What hole-making operations work on: the hole itself, or one of their own where they go to another depth or width.
#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/text.h"
#include "features/standing.h"
#include "read/stepnc/operation.h"
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
  const ToolKind tool = part_.tools[static_cast<std::size_t>(stated.operation.tool)].kind;
  const bool is_ball = tool == ToolKind::kBallEndMill;
  if (tool == ToolKind::kTSlot) return {undercut_of(draft, node)};
  if (drafts_[draft].groove && (drafts_[draft].groove->sides || is_ball)) return {groove_of(draft, stated)};
  if (!goes_straight_down(stated.operation)) return features_of_draft_[draft];
  check_previous(draft, stated, node);
  if (stated.hole == HoleKind::kTapped) return {thread_for(draft, stated, node)};
  if (drafts_[draft].thread)
    node.fail("a thread is made by TAPPING; correct the operation, or write the hole as a ROUND_HOLE");
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

namespace {

/// The end of a through hole by a drill, mm.
struct ThroughEnd {
  double beyond = 0;  ///< how much deeper than its floor the drill goes
  double over = 0;    ///< how far over the underside of the stock its width ends nevertheless
};

/// The hole has its width down to the underside if the drill's point goes below it, as far as its flutes allow after the
/// steps so far. Nothing where the hole ends elsewhere, because the point would cut what lies below it.
ThroughEnd end_of_through_hole(const Part& part, const Feature& hole, const Tool& tool,
                               const Tolerances& tol) {
  const std::optional<Stock>& stock = part.stock;
  if (!hole.through || tool.kind != ToolKind::kDrill || !stock || hole.floor_z > stock->z_bottom + kLevel)
    return {};
  const double whole = std::max(0.0, hole.floor_z - (stock->z_bottom - point_length(tool)));
  const bool reaches = !tool.flute_length || *tool.flute_length >= stock->z_top - hole.floor_z + whole;
  const double room = reaches
                          ? whole
                          : *tool.flute_length + hole.floor_z -
                                features::top_beside_tool(part, part.workplan.size(), hole.target, tool, tol);
  const double beyond = std::min(whole, std::max(0.0, room));
  return {beyond, whole - beyond};
}

}  // namespace

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
  const bool is_narrower = makes_holes(tool) && tool.diameter < *hole.hole_diameter - context_.tol.fit;
  const ThroughEnd end = is_narrower ? ThroughEnd{} : end_of_through_hole(part_, hole, tool, context_.tol);
  const double depth = stated.depth.value_or(full + end.beyond);
  if (!stated.depth && end.over > kLevel)
    context_.diagnostics.doubt(context_.file.place(node.line()), kNotFollowed,
                               "not followed: " + hole.name + " goes through, and the flutes of " +
                                   node.label() +
                                   "'s drill are too short for its point: the hole has its width down to " +
                                   trimmed(end.over, 3) + " mm over the underside; use a longer drill");
  if (std::abs(depth - full) < kLevel) return features_of_draft_[index].back();
  if (depth > full && !hole.through)
    context_.diagnostics.doubt(context_.file.place(node.line()), kNotFollowed,
                               "not followed: " + node.label() + " goes " + trimmed(depth, 3) +
                                   " mm deep (cutting_depth) and " + hole.name + " is " + trimmed(full, 3) +
                                   " mm deep; it is made no deeper");
  if (depth > full && !hole.through) return features_of_draft_[index].back();
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

/// Radians. Flanks that lean alike.
constexpr double kSameFlank = 2e-3;

/// By the flanks of its tool; a taper that leans otherwise is not made as stated.
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
  const Radians flank = Radians::of(base::atan(flank_slope(tool)));
  if (!draft.hole_diameter && std::abs(draft.wall_slope.radians() - flank.radians()) > kSameFlank)
    context_.diagnostics.doubt(context_.file.place(node.line()), kNotFollowed,
                               "not followed: the taper of " + hole.name + " leans by " +
                                   trimmed(draft.wall_slope.degrees(), 3) + " degrees, and the flank of " +
                                   node.label() + "'s tool by " + trimmed(flank.degrees(), 3) +
                                   "; give a tool of that angle");
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

namespace {

constexpr double kSameTap = 0.05;  // mm
/// A pitch that follows from feed and speed is one of a hundredth of a millimetre.
constexpr double kPitchStep = 0.01;

/// Of a tapped hole whose thread nobody states: what the tap's feed and speed make.
std::optional<Thread> thread_of_feed(const StatedOperation& stated, const Tool& tap) {
  const Operation& operation = stated.operation;
  if (!operation.cutting.feed || !operation.cutting.spindle_rpm) return std::nullopt;
  Thread thread;
  thread.diameter = tap.diameter;
  const double pitch = operation.cutting.feed->mm_per_min() / *operation.cutting.spindle_rpm;
  thread.pitch = std::round(pitch / kPitchStep) * kPitchStep;
  thread.left_hand = stated.hand == Hand::kLeft;
  thread.name =
      "M" + trimmed(thread.diameter, 3) + "x" + trimmed(thread.pitch, 3) + (thread.left_hand ? "LH" : "");
  if (!(thread.pitch > 0 && thread.pitch < tap.diameter / 2)) return std::nullopt;
  return thread;
}

/// Pitches below the full thread that a tap's lead and its room take.
constexpr double kBelowThread = 3;

}  // namespace

/// Before a tap comes a hole of the minor diameter, deep enough for its lead.
void Reader::check_core(const Feature& like, const Thread& thread, double full_z, const Node& node) const {
  const double needed = full_z - kBelowThread * thread.pitch;
  const Vec2 center = box(like.target).center();
  const bool is_there = std::any_of(part_.features.begin(), part_.features.end(), [&](const Feature& other) {
    if (other.kind != FeatureKind::kRoundHole || !other.hole_diameter || other.hole) return false;
    return distance(box(other.target).center(), center)<kLevel&& * other.hole_diameter> minor_diameter(
               thread) -
               kSameTap &&
           *other.hole_diameter < minor_diameter(thread) + minor_tolerance(thread) + kSameTap &&
           (other.through || other.floor_z < needed + kLevel);
  });
  if (is_there) return;
  node.fail("before the tap " + thread.name + " comes a hole of " + trimmed(minor_diameter(thread), 2) +
            " to " + trimmed(minor_diameter(thread) + minor_tolerance(thread), 2) + " mm down to " +
            trimmed(like.top_z - needed, 2) +
            " mm below its top, for its lead; add it, or make the thread shorter");
}

/// The thread of one tapping operation. Its tap gets the pitch, which the standard states of threads alone.
int Reader::thread_for(std::size_t index, const StatedOperation& stated, const Node& node) {
  const Draft& draft = drafts_[index];
  Tool& tap = part_.tools[static_cast<std::size_t>(stated.operation.tool)];
  const auto thread = draft.thread ? draft.thread : thread_of_feed(stated, tap);
  if (!thread)
    node.fail(
        "nothing states the thread; give a CATALOGUE_THREAD or DEFINED_THREAD as the feature, or feed and "
        "speed");
  if (!draft.thread) context_.note("the thread follows from feed and speed: " + thread->name, node);
  if (std::abs(tap.diameter - thread->diameter) > kSameTap)
    node.fail("the tap has " + trimmed(tap.diameter, 3) + " mm and the thread " +
              trimmed(thread->diameter, 3) + " mm; correct the tool");
  if (stated.hand != Hand::kUnstated && (stated.hand == Hand::kLeft) != thread->left_hand)
    node.fail(std::string("its tap is ") + (thread->left_hand ? "right" : "left") +
              "-handed (hand_of_cut), and the thread " + (thread->left_hand ? "left" : "right") +
              "-handed; correct one of them");
  if (tap.pitch > 0 &&
      (std::abs(tap.pitch - thread->pitch) > kPitchStep || tap.left_hand != thread->left_hand))
    node.fail("its tap cuts a thread of " + trimmed(tap.pitch, 3) +
              " mm pitch before; give each thread a tap");
  tap.pitch = thread->pitch;
  tap.left_hand = thread->left_hand;
  tap.floating = tap.floating || stated.is_floating;
  tap.diameter = thread->diameter;
  const Feature like = feature_of_draft(index);
  check_core(like, *thread, like.top_z - stated.depth.value_or(like.top_z - like.floor_z), node);
  const double full = like.top_z - stated.depth.value_or(like.top_z - like.floor_z);
  const int added =
      add_hole(like, draft, draft.thread ? like.name : like.name + " thread", thread->diameter, full);
  HoleForm form;
  form.kind = HoleKind::kTapped;
  form.center = {draft.placement.origin.x, draft.placement.origin.y};
  form.diameter = thread->diameter;
  form.full_z = full;
  form.thread = thread;
  Feature& feature = part_.features[static_cast<std::size_t>(added)];
  feature.hole = form;
  feature.through = like.through || (part_.stock && full < part_.stock->z_bottom + kLevel);
  return added;
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
