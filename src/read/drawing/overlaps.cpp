#include "read/drawing/overlaps.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/text.h"
#include "base/tolerances.h"
#include "geometry/contours/boolean.h"
#include "geometry/region.h"
#include "geometry/voronoi/clearance.h"
#include "read/common/text.h"
#include "read/drawing/drawing.h"
#include "read/repair/repair.h"

namespace clearcut::read {
namespace {

/// mm2. Less than this of an outline beyond an island is rounding.
constexpr double kBeyond = 0.01;

bool lies_within(const Region& region, const Regions& islands, const Tolerances& tol) {
  const bool near = std::any_of(islands.begin(), islands.end(),
                                [&](const Region& island) { return island.box().overlaps(region.box()); });
  return near && area(subtract({region}, islands, tol)) < kBeyond;
}

/// Whether a region within an island covers the whole island.
bool is_as_large(const Region& region, const Regions& islands) {
  return std::any_of(islands.begin(), islands.end(), [&](const Region& island) {
    return island.box().overlaps(region.box()) && std::abs(area({island}) - area({region})) < kBeyond;
  });
}

}  // namespace

Regions without_islands(Regions regions, const Regions& islands, const std::string& place,
                        const Tolerances& tol, Diagnostics& diagnostics) {
  Regions within, about;
  for (Region& region : regions)
    (lies_within(region, islands, tol) ? within : about).push_back(std::move(region));
  if (!about.empty()) about = subtract(about, islands, tol);
  for (Region& region : within) {
    if (is_as_large(region, islands)) {
      diagnostics.skip(place, "the outline at " + place_text(region.outer().front().from) +
                                  " is that of an island, which stays; nothing is cut there");
    } else {
      about.push_back(std::move(region));
    }
  }
  return about;
}

namespace {

/// mm2. Layers sharing less area do not overlap.
constexpr double kShared = 0.01;
/// Share of an area from which on it counts as inside another, or as equal, except for rounding.
constexpr double kWholly = 0.999;

bool are_pockets_of_one_floor(const DrawnGroup& a, const DrawnGroup& b, const ReadOptions& options) {
  const auto depth = [&](const DrawnGroup& group) { return options.depth ? options.depth : group.depth; };
  const bool same_top = options.top || a.top.value_or(0) == b.top.value_or(0);
  return is_pocket(a.role) && is_pocket(b.role) && same_top && depth(a) == depth(b);
}

/// Removes from one group the regions that overlap regions of the other, and returns them.
Regions take_overlapping(Regions& regions, const Regions& others, const Tolerances& tol) {
  Regions overlapping, apart;
  for (Region& region : regions) {
    const bool meets = near_any(others, {region}) && area(intersect({region}, others, tol)) >= kShared;
    (meets ? overlapping : apart).push_back(std::move(region));
  }
  regions = std::move(apart);
  return overlapping;
}

/// The first outline of `inner` in a pocket of `outer`.
const Region* region_within(const Regions& inner, const Regions& outer, const Tolerances& tol) {
  std::vector<Box> boxes;
  for (const Region& pocket : outer) boxes.push_back(pocket.box());
  for (const Region& region : inner) {
    const Box place = region.box();
    for (std::size_t i = 0; i < outer.size(); ++i) {
      if (boxes[i].overlaps(place) && lies_in({region}, {outer[i]}, tol)) return &region;
    }
  }
  return nullptr;
}

/// An outline of one layer in a pocket of another.
struct Within {
  const ShapedGroup* inner;
  const ShapedGroup* outer;
  const Region* region;
};

DrawingQuestion question_of(const Within& first) {
  const Box place = first.region->box();
  // Of outlines that an option has taken from the same layer by their numbers, the layer's name would say nothing.
  const bool by_number = first.inner->group.where == first.outer->group.where;
  const std::string name = by_number ? "N" : printable(first.inner->group.name);
  DrawingQuestion question{
      first.inner->group.where,
      "the outline of " + trimmed(place.width(), 2) + " x " + trimmed(place.height(), 2) + " mm at (" +
          trimmed(place.min.x, 2) + ", " + trimmed(place.min.y, 2) + ") lies in a pocket of the same depth" +
          (by_number ? "" : " on layer " + printable(first.outer->group.name)) +
          ", and nothing says what it is: --op island:" + name +
          " if it stays standing, --op pocket:" + name + " if it is milled with that pocket" +
          (by_number ? ", N being its number in `clearcut info`" : ""),
      {}};
  if (!by_number) question.answers = {{"--op", "island:" + name}, {"--op", "pocket:" + name}};
  return question;
}

/// All unclear layers, each once, in the first pocket around one of its outlines.
std::vector<Within> layers_within(const std::vector<ShapedGroup>& groups, const ReadOptions& options) {
  std::vector<Within> all;
  const auto add = [&](const ShapedGroup& inner, const ShapedGroup& outer) {
    // A layer's own depth says a pocket, in one that is said to be one.
    if (inner.group.says_role || (outer.group.says_role && inner.group.depth)) return false;
    const bool known =
        std::any_of(all.begin(), all.end(), [&](const Within& one) { return one.inner == &inner; });
    const Region* region = known ? nullptr : region_within(inner.regions, outer.regions, options.tol);
    if (region != nullptr) all.push_back({&inner, &outer, region});
    return known || region != nullptr;
  };
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const ShapedGroup &a = groups[i], &b = groups[j];
      if ((a.group.says_role && b.group.says_role) || !near_any(a.regions, b.regions) ||
          !are_pockets_of_one_floor(a.group, b.group, options)) {
        continue;
      }
      if (!add(a, b)) add(b, a);
    }
  }
  return all;
}

/// Overlapping pockets of two layers with one floor become one pocket, of the layer with the larger share: there is
/// no wall between them.
void unite_overlaps(ShapedGroup& later, ShapedGroup& earlier, const ReadOptions& options,
                    Diagnostics& diagnostics) {
  const Regions all = earlier.regions;
  const Regions from_later = take_overlapping(later.regions, all, options.tol);
  if (from_later.empty()) return;
  const Regions from_earlier = take_overlapping(earlier.regions, from_later, options.tol);
  ShapedGroup& larger = area(from_later) > area(from_earlier) ? later : earlier;
  const Regions united = unite(from_later, from_earlier, options.tol);
  larger.regions.insert(larger.regions.end(), united.begin(), united.end());
  diagnostics.note(later.group.where, "overlaps layer " + printable(earlier.group.name) +
                                          " of the same depth; what overlaps is milled as one pocket");
}

}  // namespace

bool near_any(const Regions& regions, const Regions& others) {
  const Box around = box(others);
  return std::any_of(regions.begin(), regions.end(),
                     [&](const Region& region) { return region.box().overlaps(around); });
}

bool lies_in(const Regions& inner, const Regions& outer, const Tolerances& tol) {
  const double own = area(inner);
  return own > 0 && own < kWholly * area(outer) && area(intersect(inner, outer, tol)) > kWholly * own;
}

std::optional<DrawingQuestion> question_of_layers(const std::vector<ShapedGroup>& groups,
                                                  const ReadOptions& options) {
  const std::vector<Within> all = layers_within(groups, options);
  if (all.empty()) return std::nullopt;
  DrawingQuestion question = question_of(all.front());
  std::string others;
  for (std::size_t i = 1; i < all.size(); ++i)
    others += (others.empty() ? "" : ", ") + printable(all[i].inner->group.name) + " (in " +
              printable(all[i].outer->group.name) + ")";
  if (!others.empty()) question.text += "; the same has to be said of " + others;
  return question;
}

void unite_overlapping_layers(std::vector<ShapedGroup>& groups, const ReadOptions& options,
                              Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool meet = !groups[i].regions.empty() && !groups[j].regions.empty() &&
                        are_pockets_of_one_floor(groups[i].group, groups[j].group, options);
      if (meet) unite_overlaps(groups[i], groups[j], options, diagnostics);
    }
  }
}

namespace {

bool is_pocket(const Feature& feature) {
  return feature.kind == FeatureKind::kClosedPocket;
}

/// Pockets of one depth are united elsewhere, chamfers break the edges of pockets, and isolated areas are inside
/// their own band.
bool may_be_cut_away(const Feature& feature) {
  return feature.kind != FeatureKind::kChamfer && feature.kind != FeatureKind::kIsolation &&
         feature.kind != FeatureKind::kPlanarFace && feature.kind != FeatureKind::kExternalThread;
}

/// Decided only by heights.
bool would_cut_away(const Feature& pocket, const Feature& feature) {
  if (!is_pocket(pocket) || std::abs(pocket.top_z - feature.top_z) > kSamePlaceMm) return false;
  const double deeper = feature.floor_z - pocket.floor_z;
  return is_pocket(feature) ? deeper > kSamePlaceMm : deeper > -kSamePlaceMm;
}

bool holds(const Box& outer, const Box& inner) {
  return outer.grown(kSamePlaceMm).contains(inner.min) && outer.grown(kSamePlaceMm).contains(inner.max);
}

DrawingQuestion question_of(const Feature& feature, const Feature& pocket) {
  const std::string name = printable(feature.name), layer = printable(pocket.source);
  const double depth = feature.top_z - feature.floor_z;
  std::string meant;
  std::vector<DrawingAnswer> answers;
  if (is_pocket(feature)) {
    answers.push_back({"--op", "step:" + printable(feature.source)});
    meant = "--op step:" + printable(feature.source) + " if it is a step that stays in that pocket";
  } else if (feature.carving || feature.profile) {
    meant = "if it is meant on that floor say so in its layer's name, as in TOP" +
            trimmed(pocket.floor_z, 4) + " D" + trimmed(depth, 4);
  } else {
    meant = "if it is meant on that floor give its depth from the top, as in D" +
            trimmed(feature.top_z - pocket.floor_z + depth, 4);
  }
  answers.push_back({"--op", "ignore:" + printable(feature.source)});
  return {"",
          name + " is " + trimmed(depth, 4) + " mm deep and lies in a pocket of layer " + layer +
              ", which takes all of it away: " + meant + "; --op ignore:" + printable(feature.source) +
              " leaves it out",
          answers};
}

/// Whether `pocket` would remove the step's floor.
bool reaches_below(const DrawnGroup& pocket, const DrawnGroup& step, const ReadOptions& options) {
  const bool same_top =
      options.top || std::abs(pocket.top.value_or(0) - step.top.value_or(0)) <= kSamePlaceMm;
  return is_pocket(pocket.role) && same_top && !options.depth && pocket.depth && step.depth &&
         *pocket.depth > *step.depth + kSamePlaceMm;
}

Regions beside_steps(Regions pockets, const Regions& steps, const Tolerances& tol) {
  constexpr double kOutside = 0.01;  // mm2; less is rounding
  Regions within, about;
  for (Region& region : pockets) {
    const bool meets = near_any(steps, {region});
    const bool in_step = meets && area(subtract({region}, steps, tol)) < kOutside;
    (in_step || !meets ? within : about).push_back(std::move(region));
  }
  Regions all = about.empty() ? Regions{} : subtract(about, steps, tol);
  std::move(within.begin(), within.end(), std::back_inserter(all));
  return all;
}

}  // namespace

void let_steps_stand(std::vector<ShapedGroup>& groups, const ReadOptions& options) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (groups[i].group.role != LayerRole::kStep) continue;
    for (std::size_t j = 0; j < groups.size(); ++j) {
      if (reaches_below(groups[j].group, groups[i].group, options) &&
          near_any(groups[j].regions, groups[i].regions))
        groups[j].regions = beside_steps(std::move(groups[j].regions), groups[i].regions, options.tol);
    }
  }
}

std::optional<DrawingQuestion> question_of_cut_away(const std::vector<Feature>& features,
                                                    const Tolerances& tol) {
  std::vector<Box> boxes;
  for (const Feature& feature : features) boxes.push_back(box(feature.target));
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (!may_be_cut_away(features[i])) continue;
    for (std::size_t j = 0; j < features.size(); ++j) {
      if (i != j && would_cut_away(features[j], features[i]) && holds(boxes[j], boxes[i]) &&
          lies_in(features[i].target, features[j].target, tol))
        return question_of(features[i], features[j]);
    }
  }
  return std::nullopt;
}

namespace {

/// Depth of a V-carving by the sharpest usual bit, 20 degrees, over its depth by one of 90 degrees, tan 45 / tan 10.
constexpr double kSharpest = 5.67;

/// mm; greatest depth of the feature after its cutter is chosen.
double lowest_of(const Feature& feature) {
  if (!feature.carving) return feature.floor_z;
  const double deepest = kSharpest * (feature.top_z - feature.floor_z);
  return feature.top_z - std::min(deepest, feature.carving->limit.value_or(deepest));
}

bool reaches_edge(const Feature& feature, const Box& stock, const Tolerances& tol) {
  const Box reach = box(feature.target), inner = stock.grown(-tol.join_gap / 2);
  return reach.overlaps(stock) && !(inner.contains(reach.min) && inner.contains(reach.max));
}

}  // namespace

void open_at_stock_edge(Part& part, const Tolerances& tol) {
  if (!part.stock) return;
  const Box& plan = part.stock->plan;
  const Region stock = rectangular_region(plan);
  const Region beside = frame_around(plan, kOpenReach);
  const auto is_open_already = [&](const Feature& feature) {
    return subtract({frame_around(plan, kOpenReach / 2)}, feature.allowed, tol).empty();
  };
  for (Feature& feature : part.features) {
    const bool is_area = !feature.profile && !feature.chamfer && !feature.hole_diameter;
    if (!is_area || !reaches_edge(feature, plan, tol) || is_open_already(feature)) continue;
    feature.allowed = unite(feature.allowed, {beside}, tol);
    feature.target = intersect(feature.target, {stock}, tol);
    if (feature.kind == FeatureKind::kClosedPocket) feature.kind = FeatureKind::kOpenPocket;
  }
}

void set_stock(Part& part, const std::vector<ShapedGroup>& groups, const std::vector<Feature>& features,
               const ReadOptions& options) {
  for (const ShapedGroup& shaped : groups) {
    if (shaped.group.role != LayerRole::kStock || shaped.regions.empty()) continue;
    Stock stock;
    stock.plan = box(shaped.regions);
    stock.z_top = options.top ? *options.top : shaped.group.top.value_or(0);
    stock.z_bottom = features.front().floor_z;
    for (const Feature& feature : features) stock.z_bottom = std::min(stock.z_bottom, lowest_of(feature));
    if (shaped.group.depth)
      stock.z_bottom = stock.z_top - checked_depth(*shaped.group.depth, shaped.group.where);
    part.stock = stock;
  }
}

namespace {

/// mm around a feature kept from the cutter of a face or an isolation beside it.
constexpr double kKeptWidths[] = {20, 10, 5, 2, 1, 0.5, 0.2, 0.1};

bool is_open_all_round(const Feature& feature) {
  return feature.kind == FeatureKind::kPlanarFace || feature.kind == FeatureKind::kIsolation;
}

/// Whether the feature has walls or a floor that `open` beside it could spoil. Of faces it is the floor, if that is higher; so of
/// holes beside isolated pieces, which may be thousands on a board.
bool can_be_spoiled(const Feature& feature, const Feature& open) {
  const bool is_fine = feature.hole_diameter || feature.kind == FeatureKind::kEngraving;
  const bool has_floor_alone =
      feature.kind == FeatureKind::kPlanarFace || (is_fine && open.kind == FeatureKind::kIsolation);
  return !has_floor_alone || feature.floor_z > open.floor_z + kSamePlaceMm;
}

/// mm; half the width of a line, so that it has an area. Radians; arcs of lines are chords of no more.
constexpr double kHalfLine = 0.01, kChordOfLine = 0.1;

/// A narrow strip along a line.
Regions strip_along(const Path& line, const Tolerances& tol) {
  std::vector<Loop> pieces;
  for (const Edge& edge : line) {
    const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(edge.sweep()) / kChordOfLine)));
    for (int i = 0; i < chords; ++i) {
      const Vec2 from = edge.at(static_cast<double>(i) / chords), to = edge.at((i + 1.0) / chords);
      if (distance(from, to) <= kSamePlaceMm) continue;
      const Vec2 along = (to - from) * (kHalfLine / distance(from, to)), aside{-along.y, along.x};
      const Vec2 corners[] = {from - along - aside, to + along - aside, to + along + aside,
                              from - along + aside};
      pieces.push_back(loop_from_points(corners));
    }
  }
  return unite_loops(pieces, tol);
}

/// Everything within the outlines of a feature; of a line a narrow strip; empty for broken edges.
Regions body_of(const Feature& feature, const Tolerances& tol) {
  Regions body;
  if (feature.chamfer) return body;
  if (feature.profile) {
    if (feature.profile->side == ProfileSide::kOn) return strip_along(feature.profile->line, tol);
    if (feature.profile->closed) body.push_back(Region::from_valid_loops(feature.profile->line, {}));
    return body;
  }
  for (const Region& region : feature.target) body.push_back(Region::from_valid_loops(region.outer(), {}));
  return body;
}

/// mm; the share of the material between `open` and the feature apart from it that is kept. 0: they touch, one is within the other, or
/// the material is kept anyway.
double kept_width(const Regions& body, const Feature& open, const Tolerances& tol) {
  const Vec2 place = body.front().outer().front().from;
  if (contains(open.target, place) || !contains(open.allowed, place)) return 0;
  for (const double width : kKeptWidths) {
    if (!box(body).grown(2 * width).overlaps(box(open.target))) return width;
    if (intersect(dilate(body, 2 * width, tol), open.target, tol).empty()) return width;
  }
  return 0;
}

}  // namespace

void keep_open_features_off_others(std::vector<Feature>& features, const Tolerances& tol) {
  for (Feature& open : features) {
    if (!is_open_all_round(open)) continue;
    Regions kept;
    for (const Feature& other : features) {
      if (&other == &open || !can_be_spoiled(other, open)) continue;
      const Regions body = body_of(other, tol);
      const double width = body.empty() ? 0 : kept_width(body, open, tol);
      if (width == 0) continue;
      const Regions around = dilate(body, width, tol);
      kept.insert(kept.end(), around.begin(), around.end());
    }
    if (!kept.empty()) open.allowed = subtract(open.allowed, unite_all(kept, tol), tol);
  }
}

}  // namespace clearcut::read
