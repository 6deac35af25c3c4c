#include "read/drawing/drawn_holes.h"

#include <algorithm>

#include "base/error.h"
#include "base/text/format.h"
#include "geometry/region.h"
#include "read/repair/mends.h"

namespace clearcut::read {
namespace {

/// A thread around a boss: its cut is the ring between the root and the drawn circle.
void form_external_thread(Feature& feature, const HoleRequest& request, const std::string& place) {
  const Thread& thread = *request.thread;
  const double drawn = *feature.hole_diameter;
  constexpr double kRounding = 0.005;  // mm
  if (drawn > thread.diameter + kRounding || drawn < thread.diameter - crest_tolerance(thread) - kRounding)
    throw InputError(place, "the boss of its thread " + thread.name + " is drawn " + trimmed(drawn, 3) +
                                " mm wide; draw it " + trimmed(thread.diameter - crest_tolerance(thread), 3) +
                                " to " + trimmed(thread.diameter, 3) + " mm");
  if (request.through)
    throw InputError(place,
                     "a thread about a boss cannot go through; say how far down it is full, as in "
                     "THREAD_M20_EXTERNAL_D12");
  HoleForm form;
  form.kind = HoleKind::kThreadMilled;
  form.center = feature.target.front().outer().front().center;
  form.diameter = thread.diameter;
  form.full_z = feature.floor_z;
  form.thread = thread;
  form.external = true;
  feature.kind = FeatureKind::kExternalThread;
  feature.hole_diameter.reset();
  const Region ring = Region::from_valid_loops(disc_about(form.center, drawn / 2).outer(),
                                               {disc_about(form.center, root_diameter(thread) / 2).outer()});
  feature.target = feature.allowed = {ring};
  feature.hole = form;
}

std::optional<double> thickness_of(const std::vector<ShapedGroup>& groups, const ReadOptions& options) {
  if (options.solid.stock) return options.solid.stock->z[1] - options.solid.stock->z[0];
  for (const ShapedGroup& shaped : groups) {
    if (shaped.group.role == LayerRole::kStock && shaped.group.depth) return shaped.group.depth;
  }
  return std::nullopt;
}

void form_hole(Feature& feature, const HoleRequest& request, const std::string& place) {
  const bool threaded = request.kind == HoleKind::kTapped || request.kind == HoleKind::kThreadMilled;
  if (threaded && !request.thread) {
    throw InputError(place,
                     "it is to be threaded and names no thread there is a table for; name the layer like "
                     "TAP_M6_D12, THREAD_M20x1.5_THRU, TAP_UNC1-4_D12 or TAP_#10-24_D10");
  }
  if (request.external && request.kind == HoleKind::kThreadMilled)
    return form_external_thread(feature, request, place);
  HoleForm form;
  form.kind = request.kind;
  form.center = feature.target.front().outer().front().center;
  form.diameter = threaded ? request.thread->diameter : request.diameter.value_or(*feature.hole_diameter);
  form.full_z = feature.floor_z;
  if (threaded) form.thread = request.thread;
  form.chip_break = request.chip_break;
  form.peck = request.peck;
  feature.through = request.through;
  feature.hole_diameter = form.diameter;
  feature.target = feature.allowed = {disc_about(form.center, form.diameter / 2)};
  feature.hole = form;
}

}  // namespace

std::optional<HoleRequest> scaled(std::optional<HoleRequest> request, double mm_per_unit) {
  if (!request) return request;
  if (request->diameter) *request->diameter *= mm_per_unit;
  if (request->peck) *request->peck *= mm_per_unit;
  return request;
}

bool is_external_thread(const DrawnGroup& group) {
  return group.hole && group.hole->external && group.hole->kind == HoleKind::kThreadMilled;
}

bool needs_no_depth(const HoleRequest& request) {
  return request.kind == HoleKind::kCountersunk || request.kind == HoleKind::kSpotted;
}

void make_hole(Feature& feature, const DrawnGroup& group, const Tolerances& tol) {
  const Region& region = feature.target.front();
  feature.hole_diameter = circle_diameter(region, tol);
  if (!feature.hole_diameter) {
    throw InputError(group.where,
                     "the outline at " + place_text(region.outer().front().from) +
                         " is on a layer of holes and is no circle; draw a circle or rename the layer");
  }
  feature.kind = FeatureKind::kRoundHole;
  if (group.hole) form_hole(feature, *group.hole, group.where);
}

bool comes_after_pilot(const Feature& feature) {
  return feature.hole && feature.hole->kind != HoleKind::kDrilled &&
         feature.hole->kind != HoleKind::kSpotted && feature.hole->kind != HoleKind::kCounterbored;
}

void give_through_depths(std::vector<ShapedGroup>& groups, const ReadOptions& options) {
  const auto thickness = thickness_of(groups, options);
  for (ShapedGroup& shaped : groups) {
    DrawnGroup& group = shaped.group;
    if (!group.hole || !group.hole->through || group.depth || options.depth) continue;
    if (!thickness)
      throw InputError(
          group.where,
          "it goes through, and nothing says how thick the material is; add an outline on a layer "
          "STOCK_D12 (12 mm thick), or a depth, as in TAP_M6_THRU_D12");
    group.depth = *thickness + std::min(0.0, group.top.value_or(0));
  }
}

}  // namespace clearcut::read
