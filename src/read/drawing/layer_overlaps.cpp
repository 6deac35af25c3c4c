#include "read/drawing/layer_overlaps.h"

#include <algorithm>

#include "base/text/format.h"
#include "geometry/contours/boolean.h"
#include "read/common/text.h"

namespace clearcut::read {
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
  const std::string name = printable(first.inner->group.name);
  return DrawingQuestion{
      first.inner->group.where,
      "the outline of " + trimmed(place.width(), 2) + " x " + trimmed(place.height(), 2) + " mm at (" +
          trimmed(place.min.x, 2) + ", " + trimmed(place.min.y, 2) +
          ") lies in a pocket of the same depth on layer " + printable(first.outer->group.name) +
          ", and nothing says what it is: --op island:" + name +
          " if it stays standing, --op pocket:" + name + " if it is milled with that pocket",
      {{"--op", "island:" + name}, {"--op", "pocket:" + name}}};
}

/// All unclear layers, each once, in the first pocket around one of its outlines.
std::vector<Within> layers_within(const std::vector<ShapedGroup>& groups, const ReadOptions& options) {
  std::vector<Within> all;
  const auto add = [&](const ShapedGroup& inner, const ShapedGroup& outer) {
    const bool known =
        std::any_of(all.begin(), all.end(), [&](const Within& one) { return one.inner == &inner; });
    const Region* region = known ? nullptr : region_within(inner.regions, outer.regions, options.tol);
    if (region != nullptr) all.push_back({&inner, &outer, region});
    return known || region != nullptr;
  };
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const ShapedGroup &a = groups[i], &b = groups[j];
      if (a.group.says_role || b.group.says_role || !near_any(a.regions, b.regions) ||
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

}  // namespace clearcut::read
