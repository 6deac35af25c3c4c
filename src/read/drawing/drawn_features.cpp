#include "read/drawing/drawn_features.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "features/derived_outlines.h"
#include "geometry/contours/boolean.h"
#include "geometry/region.h"
#include "geometry/voronoi/clearance.h"
#include "read/drawing/layer_rules.h"
#include "read/repair/repair.h"

namespace clearcut::read {
namespace {

/// mm. Chamfers without a depth.
constexpr double kEdgeBreak = 0.2;
/// mm. Default width of bands around copper.
constexpr double kIsolation = 0.3;

}  // namespace

Feature blank_feature(const DrawnGroup& group, double depth, const ReadOptions& options) {
  Feature feature;
  feature.name = group.name == "0" ? name_of(group.role) : group.name;
  feature.source = group.name;
  feature.top_z = options.top ? *options.top : group.top.value_or(0);
  feature.floor_z = feature.top_z - depth;
  return feature;
}

Feature face_of(const DrawnGroup& group, const Region& region, double depth, const ReadOptions& options) {
  Feature feature = blank_feature(group, depth, options);
  feature.kind = FeatureKind::kPlanarFace;
  feature.target = {Region::from_valid_loops(region.outer(), {})};
  feature.allowed = {rectangular_region(region.box().grown(kOpenReach))};
  return feature;
}

Feature carving_of(const DrawnGroup& group, Region region, const ReadOptions& options) {
  const std::optional<double> asked = options.depth ? options.depth : group.depth;
  VCarving carving;
  if (asked) carving.limit = checked_depth(*asked, group.where);
  const double widest = Clearance(region, options.tol).max();
  Feature feature = blank_feature(group, std::min(widest, carving.limit.value_or(widest)), options);
  feature.kind = FeatureKind::kVCarving;
  feature.target = {std::move(region)};
  feature.allowed = feature.target;
  carving.start = group.start;
  feature.carving = carving;
  return feature;
}

Feature isolation_of(const ShapedGroup& shaped, double depth, const ReadOptions& options,
                     Diagnostics& diagnostics) {
  const DrawnGroup& group = shaped.group;
  if (!group.width) {
    diagnostics.note(group.where, "a band of " + trimmed(kIsolation, 2) +
                                      " mm is milled about each piece (another width: isolate_w0.4)");
  }
  const double width = checked_length(group.width.value_or(kIsolation), "width", group.where);
  Feature feature = blank_feature(group, depth, options);
  feature.kind = FeatureKind::kIsolation;
  feature.target = subtract(dilate(shaped.regions, width, options.tol), shaped.regions, options.tol);
  feature.allowed =
      subtract({rectangular_region(box(shaped.regions).grown(kOpenReach))}, shaped.regions, options.tol);
  return feature;
}

void add_chamfers(const ShapedGroup& shaped, const ReadOptions& options, Diagnostics& diagnostics,
                  std::vector<Feature>& out) {
  // --depth applies to pockets.
  if (!shaped.group.depth) diagnostics.note(shaped.group.where, "no depth given: edges are broken by 0.2 mm");
  const double depth = checked_depth(shaped.group.depth.value_or(kEdgeBreak), shaped.group.where);
  for (const Region& region : shaped.regions) {
    for (Loop& loop : loops_of({region})) {
      Feature feature = blank_feature(shaped.group, depth, options);
      feature.kind = FeatureKind::kChamfer;
      feature.target = feature.allowed =
          features::kerf_of({ProfileSide::kOn, loop, true, 0, {}}, depth, options.tol);
      feature.chamfer = Chamfer{std::move(loop), depth, true, {}, 0, 0};
      out.push_back(std::move(feature));
    }
  }
}

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
