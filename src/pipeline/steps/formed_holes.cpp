#include "pipeline/steps/formed_holes.h"

#include <algorithm>
#include <cmath>

#include "link/hole.h"
#include "link/tracks/thread.h"
#include "pipeline/steps/certify.h"
#include "post/post.h"

namespace clearcut::pipeline {
namespace {

/// Pitches above the material at which a tap begins to feed, but at least 2 mm: the spindle then has reached its
/// speed.
constexpr double kPitchesAbove = 3;
constexpr double kLeastAboveTap = 2;
/// mm; distance of a mill from a thread's diameter in addition to its displacement by coarse digits.
constexpr double kOffThread = 0.0005;

double tip_of_cone(const Feature& feature, const Tool& tool) {
  return feature.top_z - (feature.hole->diameter / 2 - tool.tip_diameter / 2) / flank_slope(tool);
}

/// mm; distance kept by a place displaced by up to `rounding` mm: half of the smallest gouge remains. 0 if the
/// displacement is less than a gouge.
double kept_off(double rounding, const ResolvedPlan& plan) {
  return rounding <= plan.tol.gouge ? 0 : rounding - plan.tol.gouge / 2;
}

/// mm; rise of a hole's bottom, so that coarse digits put no tap or tip lower than half of the smallest gouge. 0 if
/// the digits' error is smaller.
double raise_of_depth(const ResolvedPlan& plan) {
  return kept_off(post::rounding_of_lines(plan.post) * std::sqrt(0.5), plan);  // along one axis
}

/// mm; rise of a cone for the same reason: rounding of its place also moves its flanks nearer.
double raise_of_cone(const Tool& tool, const ResolvedPlan& plan) {
  return raise_of_depth(plan) + kept_off(post::rounding_of_lines(plan.post), plan) / flank_slope(tool);
}

link::ThreadWork thread_work(const Feature& feature, const Tool& tool, double off) {
  const HoleForm& hole = *feature.hole;
  link::ThreadWork work;
  work.center = hole.center;
  work.external = hole.external;
  work.radius = hole.external ? root_diameter(*hole.thread) / 2 + off : hole.diameter / 2 - off;
  work.crest = hole.diameter / 2;
  work.aside = approach_beside(*hole.thread);
  work.pitch = hole.thread->pitch;
  work.left_hand = hole.thread->left_hand;
  work.z_top = feature.top_z;
  work.full_z = hole.full_z;
  if (tool.pitch > 0 && tool.flute_length)
    work.rows = std::max(1.0, std::floor(*tool.flute_length / tool.pitch + 1e-9)) * hole.thread->pitch;
  return work;
}

}  // namespace

std::optional<Section> formed_hole_step(int workingstep, const ResolvedPlan& plan) {
  const Workingstep& step = plan.part.workplan.at(static_cast<std::size_t>(workingstep));
  const Feature& feature = feature_of(plan.part, step);
  if (!is_formed(feature)) return std::nullopt;
  const Tool& tool = tool_of(plan.part, step);
  link::LinkOptions link = link_options(plan, workingstep, EntryKind::kPlunge);
  const HoleForm& hole = *feature.hole;
  Section section;
  if (hole.kind == HoleKind::kTapped) {
    link.above_material = std::max(kLeastAboveTap, kPitchesAbove * tool.pitch);
    section = link::feed_out_hole(
        {hole.center, tool.radius(), feature.top_z, feature.floor_z + raise_of_depth(plan)}, link);
  } else if (hole.kind == HoleKind::kThreadMilled) {
    section = link::mill_thread(thread_work(feature, tool, kOffThread + post::rounding_of(plan.post)), link);
  } else {
    const double tip = tip_of_cone(feature, tool) + raise_of_cone(tool, plan);
    section = link::drill_hole({hole.center, tool.radius(), feature.top_z, tip}, feature.top_z - tip, link);
  }
  describe(section, workingstep, plan);
  return section;
}

}  // namespace clearcut::pipeline
