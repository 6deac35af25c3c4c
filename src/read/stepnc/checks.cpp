// Whether the tools of a program leave what its features ask for: the depth, width and bottom of holes, fillets of floors.
#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/text.h"
#include "model/tool.h"
#include "read/stepnc/operation.h"
#include "read/stepnc/reader.h"

namespace clearcut::read::stepnc {

/// Parts of patterns and compounds that nobody makes, where others are made.
void Reader::check_members() {
  const auto is_made = [&](std::size_t draft) {
    const auto steps = steps_of_draft_.find(draft);
    return steps != steps_of_draft_.end() && !steps->second.empty();
  };
  for (const auto& [feature, drafts] : drafts_of_) {
    if (std::none_of(drafts.begin(), drafts.end(), is_made) || left_out_.count(feature)) continue;
    const P21Entity* whole = context_.file.find(feature);
    for (const std::size_t draft : drafts) {
      const Node& part = drafts_[draft].node;
      if (is_made(draft) || bad_drafts_.count(draft) || left_out_.count(part.id())) continue;
      context_.diagnostics.doubt(context_.file.place(part.line()), kNotFollowed,
                                 part.label() + ", a part of " + Node(context_.file, *whole).label() +
                                     ", is made by no workingstep");
    }
  }
}

/// What round holes lack when all steps are made.
void Reader::check_holes() {
  for (const auto& [index, steps] : steps_of_draft_) {
    const Draft& draft = drafts_[index];
    if (!draft.hole_diameter || draft.thread || steps.empty())
      continue;  // threads are checked where they are cut
    const Feature& hole = feature_of_draft(index);
    double deepest = kEverywhere;
    for (const std::size_t step : steps)
      if (feature_of(part_.workplan[step]).hole_diameter == hole.hole_diameter ||
          !goes_straight_down(part_.workplan[step].operation))
        deepest = std::min(deepest, feature_of(part_.workplan[step]).floor_z);
    if (deepest > hole.floor_z + kLevel)
      context_.diagnostics.doubt(
          context_.file.place(draft.node.line()), kNotFollowed,
          draft.node.label() + ": " +
              (deepest == kEverywhere ? "no operation makes the hole to its width"
                                      : "its operations go " + trimmed(hole.top_z - deepest, 3) + " of the " +
                                            trimmed(hole.top_z - hole.floor_z, 3) + " mm down"));
    if (!draft.through) check_hole_end(draft, steps);
  }
}

/// What is said to go through, and ends over the underside of the stock with nothing below it. In programs of several set-ups another one may
/// cut what is below.
void Reader::check_through_ends() {
  if (!part_.stock || program_.setups.size() > 1) return;
  for (const auto& [index, steps] : steps_of_draft_) {
    const Draft& draft = drafts_[index];
    if (!draft.through || steps.empty()) continue;
    const Feature& feature = feature_of_draft(index);
    const double short_by = feature.floor_z - part_.stock->z_bottom;
    const auto is_below = [&](const Feature& other) {
      return other.floor_z < feature.floor_z - kLevel && box(other.target).overlaps(box(feature.target));
    };
    if (short_by <= kLevel || std::any_of(part_.features.begin(), part_.features.end(), is_below)) continue;
    context_.diagnostics.doubt(context_.file.place(draft.node.line()), kNotFollowed,
                               "not followed: " + draft.node.label() +
                                   " is said to go through, and its depth ends " + trimmed(short_by, 3) +
                                   " mm over the underside of the stock; it is cut as deep as that");
  }
}

/// Whether the tools leave the bottom that is asked for.
void Reader::check_hole_end(const Draft& draft, const std::vector<std::size_t>& steps) {
  constexpr double kSameTip = 0.0175;   // radians: a degree
  constexpr double kSameCorner = 0.05;  // mm
  const HoleEnd& end = draft.hole_end;
  bool drilled = false, milled = false, ends_so = false, said = true;
  double point = kEverywhere, depth = 0;  // mm; of the drill with the shortest point, and of the hole
  for (const std::size_t step : steps) {
    const Tool& tool = tool_of_step(step);
    const bool straight = goes_straight_down(part_.workplan[step].operation);
    drilled = drilled || (straight && tool.kind == ToolKind::kDrill);
    milled = milled || !straight;
    if (straight) point = std::min(point, point_length(tool));
    const Feature& hole = feature_of(part_.workplan[step]);
    depth = std::max(depth, hole.top_z - hole.floor_z);
    if (end.bottom == HoleBottom::kCone && straight && tool.kind == ToolKind::kDrill) {
      said = said && tool.tip_angle.has_value();
      ends_so = ends_so ||
                (tool.tip_angle && std::abs(tool.tip_angle->radians() - end.angle->radians()) < kSameTip);
    }
    const bool is_round = end.bottom == HoleBottom::kBall || end.bottom == HoleBottom::kFlatWithRadius;
    if (is_round && std::abs(tool.corner_radius - end.radius) < kSameCorner) ends_so = true;
  }
  const std::string where = context_.file.place(draft.node.line());
  const std::string name = draft.node.label();
  if (drilled && !milled && depth < point - kLevel)
    context_.diagnostics.warn(
        where, name + ": it is " + trimmed(depth, 3) + " mm deep, and the point of its drill is " +
                   trimmed(point, 3) +
                   " mm long: nowhere has it its diameter; mill it, or state a greater depth");
  if (end.bottom == HoleBottom::kFlat) {
    if (drilled && !milled)
      context_.note("its flat bottom ends in the cone of the drill, whose tip goes down to the depth",
                    draft.node);
  } else if (end.bottom == HoleBottom::kCone && !milled && !said) {
    context_.note("its conical bottom of " + trimmed(end.angle->degrees(), 3) +
                      " degrees is left to the drill, whose point is not stated",
                  draft.node);
  } else if (end.bottom == HoleBottom::kCone && (milled || !ends_so)) {
    context_.diagnostics.doubt(where, kNotFollowed,
                               "not followed: the bottom of " + name + ", a cone of " +
                                   trimmed(end.angle->degrees(), 3) + " degrees; its tools end otherwise");
  } else if (end.bottom != HoleBottom::kCone && !ends_so) {
    context_.diagnostics.doubt(where, kNotFollowed,
                               "not followed: the bottom of " + name + " with a radius of " +
                                   trimmed(end.radius, 3) + " mm; its tools end otherwise");
  }
}

namespace {

/// Radii of the corners of a pocket's outline that arcs round: of those that turn to the left where it runs counter-clockwise.
double narrowest_corner(const Draft& draft) {
  double narrowest = kEverywhere;
  const bool reverse = signed_area(draft.boundary) < 0;
  const Loop loop = reverse ? reversed(draft.boundary) : draft.boundary;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (loop[i].turn == Turn::kCounterClockwise) narrowest = std::min(narrowest, loop[i].radius());
  }
  return narrowest;
}

}  // namespace

/// Some writers put the radius of the corners seen from above, which their outlines have, in the place of the fillet of the floor.
bool Reader::fillets_are_in_plan() const {
  constexpr double kSame = 0.01;  // mm
  bool found = false;
  for (const Draft& draft : drafts_) {
    if (!draft.floor_fillet || draft.boundary.empty()) continue;
    const double narrowest = narrowest_corner(draft);
    if (narrowest < draft.floor_fillet->size - kSame) return false;
    found = found || std::abs(narrowest - draft.floor_fillet->size) < kSame;
  }
  return found;
}

void Reader::check_fillets() {
  const bool in_plan = fillets_in_plan_;
  for (const auto& [index, steps] : steps_of_draft_) {
    const Draft& draft = drafts_[index];
    if (!draft.floor_fillet || draft.through) continue;
    if (in_plan && !draft.boundary.empty())
      context_.warn(
          "the radius of its floor fillet (planar_radius) is that of the corners of its outline, and is read "
          "as theirs",
          draft.node);
    else
      check_fillet(index, steps);
  }
}

/// A cutter whose own corner is sharper cuts the fillet away; one that is rounder leaves more of it. A fillet that the file's own cutters
/// cannot leave is an open condition, and no gouge of each of their passes.
void Reader::check_fillet(std::size_t index, const std::vector<std::size_t>& steps) {
  const Draft& draft = drafts_[index];
  const double radius = draft.floor_fillet->size - draft.floor_fillet->below;
  double deepest = 0, sharpest = kEverywhere;
  for (const std::size_t step : steps) {
    const Operation& operation = part_.workplan[step].operation;
    const double corner = tool_of_step(step).corner_radius;
    sharpest = std::min(sharpest, corner);
    const double aside = radius - corner - operation.allowance_side;
    const double down = radius - corner - operation.allowance_floor;
    if (aside > 0 && down > 0) deepest = std::max(deepest, base::hypot(aside, down) + corner - radius);
  }
  const std::string asked =
      "the floor fillet of " + draft.node.label() + " of " + trimmed(draft.floor_fillet->size, 3) + " mm";
  const std::string where = context_.file.place(draft.node.line());
  if (deepest > kLevel) {
    context_.diagnostics.doubt(where, kNotFollowed,
                               "not followed: " + asked + "; the corner of its cutters has " +
                                   trimmed(sharpest, 3) + " mm and cuts " + trimmed(deepest, 3) +
                                   " mm into it; give a bull-nose mill of that radius");
    for (const int feature : features_of_draft_[index])
      part_.features[static_cast<std::size_t>(feature)].floor_fillet = 0;
  } else if (sharpest > draft.floor_fillet->size + draft.floor_fillet->above + kLevel)
    context_.diagnostics.warn(where, asked + " is that of the cutter, " + trimmed(sharpest, 3) + " mm");
}

}  // namespace clearcut::read::stepnc
