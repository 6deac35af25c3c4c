#include "read/drawing/area_features.h"

#include "base/error.h"
#include "base/text/format.h"
#include "features/kerf.h"
#include "geometry/contours/boolean.h"
#include "geometry/contours/loops.h"
#include "geometry/rectangle.h"
#include "geometry/voronoi/clearance.h"
#include "read/drawing/layer_rules.h"

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

}  // namespace clearcut::read
