#include "resolve/profiles.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text/format.h"
#include "geometry/boolean.h"
#include "geometry/clearance.h"
#include "stock/kerf.h"
#include "stock/round_hole.h"

namespace clearcut::resolve {
namespace {

/// mm. The same for cutters of any size.
constexpr double kToolSpare = 0.01;
/// mm. Stock on walls for finishing where nobody says how much.
constexpr double kFinishStock = 0.3;
/// mm2. What a boolean leaves of areas that only touch.
constexpr double kSpeck = 0.01;
/// Of the cutter's radius: how far the far side of the kerf may be cut beyond it. More would let ramps and rapids leave the
/// contour for what stands beside it.
constexpr double kBeyondKerf = 0.02;
/// Of the cutter's radius: how far around a profile others are looked for.
constexpr double kBand = 3;
/// mm. How far the cutter's rim may stray from an engraved line's.
constexpr double kBesideLine = 0.005;
/// mm. Kerfs end this much before the cutter's widest place beside a tab.
constexpr double kBeforeTab = 0.02;
/// mm. Tabs that nobody measured are no higher.
constexpr double kTabHeight = 2;
/// Of their depth.
constexpr double kTabShare = 0.5;
/// mm. Kerfs that overlap by less only touch.
constexpr double kRounding = 1e-6;
/// mm along the outline between places that are looked at for a tab.
constexpr double kTabSearch = 0.5;

Regions within(const ProfileCut& cut) {
  return {Region::from_valid_loops(cut.line, {})};
}

/// What belongs to parts near `cut`: of all profiles from large to small the outer ones add, the inner ones take away.
Regions solid_around(const Part& part, const ProfileCut& cut, double reach, const Tolerances& tol) {
  const Box near = box(cut.line).grown(reach);
  std::vector<const ProfileCut*> others;
  for (const Feature& feature : part.features) {
    if (feature.profile && feature.profile->side != ProfileSide::kOn && feature.profile->tabs.empty() &&
        box(feature.profile->line).overlaps(near))
      others.push_back(&*feature.profile);
  }
  std::stable_sort(others.begin(), others.end(), [](const ProfileCut* a, const ProfileCut* b) {
    return std::abs(signed_area(a->line)) > std::abs(signed_area(b->line));
  });
  Regions solid;
  for (const ProfileCut* other : others) {
    if (other->side == ProfileSide::kOutside) {
      solid = solid.empty() ? within(*other) : unite(solid, within(*other), tol);
    } else if (!solid.empty()) {
      solid = subtract(solid, within(*other), tol);
    }
  }
  return solid;
}

/// mm across the kerf of a profile: what its cutter may take, with stock left for finishing on both sides.
double allowed_width(double radius, double stock) {
  return (2 + kBeyondKerf) * radius + kToolSpare + 2 * stock;
}

void shape(Feature& feature, const Part& part, double radius, double stock, const Tolerances& tol) {
  const ProfileCut& cut = *feature.profile;
  if (cut.side == ProfileSide::kOn) {
    feature.target = stock::kerf_of(cut, 2 * radius, tol);
    feature.allowed = stock::kerf_of(cut, 2 * (radius + kBesideLine), tol);
    return;
  }
  const Regions solid = solid_around(part, cut, kBand * radius, tol);
  feature.target = stock::kerf_of(cut, 2 * radius, tol);
  feature.allowed = stock::kerf_of(cut, allowed_width(radius, stock), tol);
  // Without others in the way it stays exact as it is.
  if (solid.empty() || area(intersect(feature.allowed, solid, tol)) < kSpeck) return;
  feature.target = subtract(feature.target, solid, tol);
  feature.allowed = subtract(feature.allowed, solid, tol);
}

/// A stretch of one edge of the outline.
struct Stretch {
  std::size_t edge = 0;
  double from = 0;  ///< mm from the edge's start
  double to = 0;
};

class TabPlacer {
 public:
  /// `kerf`: mm, the width of what the cutter may take.
  TabPlacer(const ProfileCut& cut, double radius, double kerf, const TabOptions& options)
      : cut_(cut), radius_(radius), kerf_(kerf), options_(options) {
    double at = 0;
    for (const Edge& edge : cut.line) {
      starts_.push_back(at);
      at += edge.length();
    }
    around_ = at;
  }

  /// Middles of the tabs, mm along the outline, spread evenly as far as places allow; fewer where they do not fit.
  std::vector<double> places() const {
    std::vector<double> chosen;
    for (int i = 0; i < options_.count; ++i) {
      const double wanted = around_ * (i + 0.5) / options_.count;
      for (double away = 0; away <= around_ / 2; away += kTabSearch) {
        const double ahead = std::fmod(wanted + away, around_);
        const double back = std::fmod(wanted - away + around_, around_);
        const double place = fits(ahead, chosen) ? ahead : back;
        if (!fits(place, chosen)) continue;
        chosen.push_back(place);
        break;
      }
    }
    return chosen;
  }

  /// Outline's stretch of `half` mm to both sides of the middle, moved over the kerf; no farther, for beyond it may lie the
  /// kerf of another side.
  Regions across(double middle, double half) const {
    const Stretch on = stretch(middle, half);
    const Edge& edge = cut_.line[on.edge];
    const Edge piece = edge.part(on.from / edge.length(), on.to / edge.length());
    // A little of the part goes along, so that no sliver stays between.
    const double side = free_side();
    const Edge near = moved(piece, -side * kOverlap),
               far = moved(piece, side * (kerf_ + kOverlap)).reversed();
    return {Region::from_valid_loops(
        {near, Edge::line(near.to, far.from), far, Edge::line(far.to, near.from)}, {})};
  }

  Vec2 middle_of_kerf(double middle) const {
    const Stretch on = stretch(middle, 0);
    const Edge& edge = cut_.line[on.edge];
    const double t = std::clamp(on.from / edge.length(), 0.0, 1.0);
    return edge.at(t) + left_of(edge.tangent_at(t)) * (free_side() * radius_);
  }

  /// mm along the outline, to both sides of the middle, over which the cutter's widest place cannot be at depth.
  double half_gap(double middle) const {
    const Edge& edge = cut_.line[stretch(middle, 0).edge];
    if (!edge.is_arc()) return options_.width / 2 + radius_;
    // The tab's sides run to the arc's centre; the cutter touches them from a circle about it.
    const bool hollow = (edge.turn == Turn::kCounterClockwise) == (cut_.side == ProfileSide::kInside);
    const double around = edge.radius() + (hollow ? -kerf_ / 2 : radius_);
    return options_.width / 2 +
           edge.radius() * base::asin(std::min(1.0, radius_ / std::max(around, radius_)));
  }

 private:
  static constexpr double kOverlap = 0.01;  ///< mm
  static constexpr double kNarrowArc =
      1.25;  ///< Of the kerf. Radius of arcs that are too narrow to move across it.

  static Edge moved(const Edge& edge, double d) {
    Edge out = edge;
    out.from = edge.from + left_of(edge.tangent_at(0)) * d;
    out.to = edge.to + left_of(edge.tangent_at(1)) * d;
    return out;
  }

  Stretch stretch(double middle, double half) const {
    const auto after = std::upper_bound(starts_.begin(), starts_.end(), middle);
    const auto edge = static_cast<std::size_t>(after - starts_.begin()) - 1;
    return {edge, middle - starts_[edge] - half, middle - starts_[edge] + half};
  }

  /// On one line, or an arc much wider than the tab, away from corners and other tabs.
  bool fits(double middle, const std::vector<double>& chosen) const {
    const double half = half_gap(middle) + kBeforeTab;
    const Stretch on = stretch(middle, half);
    const Edge& edge = cut_.line[on.edge];
    // The kerf along the next side must not run into it.
    const double clear = kerf_ + kOverlap;
    if (on.from < clear || on.to > edge.length() - clear) return false;
    if (edge.is_arc() && edge.radius() < std::max(2 * half, kNarrowArc * kerf_)) return false;
    const bool apart_from_others = std::all_of(chosen.begin(), chosen.end(), [&](double other) {
      const double apart = std::abs(other - middle);
      return std::min(apart, around_ - apart) > 2 * half + radius_;
    });
    return apart_from_others && is_free(on);
  }

  /// Whether no kerf along another side, in a notch or an acute corner, comes into the stretch's own: a tab there would be cut,
  /// and nothing stands beyond it that it could hold.
  bool is_free(const Stretch& on) const {
    const Edge& own = cut_.line[on.edge];
    const double kerf = kerf_ + kOverlap;
    const Edge far = moved(own.part(on.from / own.length(), on.to / own.length()), free_side() * kerf);
    const Box reached = far.box().grown(kerf);
    for (std::size_t i = 0; i < cut_.line.size(); ++i) {
      const Edge& other = cut_.line[i];
      if (i != on.edge && other.box().overlaps(reached) && distance(far, other) < kerf - kRounding)
        return false;
    }
    return true;
  }

  /// Of which side of the outline the free side is: right of a counter-clockwise one for outer profiles.
  double free_side() const { return cut_.side == ProfileSide::kOutside ? -1 : 1; }

  const ProfileCut& cut_;
  double radius_;
  double kerf_;
  const TabOptions& options_;
  std::vector<double> starts_;
  double around_ = 0;
};

std::vector<Tab> tabs_of(const Feature& feature, const TabPlacer& placer, double top_z,
                         const TabOptions& options) {
  std::vector<Tab> tabs;
  for (const double place : placer.places()) {
    Tab tab;
    tab.center = placer.middle_of_kerf(place);
    tab.width = options.width;
    tab.top_z = top_z;
    tab.bottom_z = feature.floor_z;
    tab.body = placer.across(place, options.width / 2);
    tabs.push_back(std::move(tab));
  }
  return tabs;
}

/// The layers below the tabs' tops; `feature` keeps those above.
std::optional<Feature> split_at_tabs(Feature& feature, double radius, double stock, Part& part,
                                     const PlanOptions& options) {
  const TabPlacer placer(*feature.profile, radius, allowed_width(radius, stock), options.tabs);
  const double under = feature.floor_z + feature.profile->beyond;
  const double height =
      options.tabs.height.value_or(std::min(kTabHeight, kTabShare * (feature.top_z - under)));
  const double top = under + height;
  if (top >= feature.top_z) {
    throw InputError("--tab-height", trimmed(height, 3) + " mm is as high as the profile " + feature.name +
                                         " is deep; make it lower");
  }
  std::vector<Tab> tabs = tabs_of(feature, placer, top, options.tabs);
  const int count = static_cast<int>(tabs.size());
  if (count < options.tabs.count) {
    const std::string what = "only " + std::to_string(count) + " of " + std::to_string(options.tabs.count) +
                             " tabs of " + trimmed(options.tabs.width, 2) +
                             " mm fit on straight stretches and wide arcs of ";
    if (feature.profile->side == ProfileSide::kOutside) {
      throw InputError("--tabs", what + feature.name + "; ask for fewer or narrower ones (--tab-width)");
    }
    part.diagnostics.warn(feature.name, what + feature.name + "; what it cuts free is held by no more");
  }
  if (tabs.empty()) return std::nullopt;
  Feature below = feature;
  below.name = feature.name + "_tabs";
  below.top_z = top;
  feature.floor_z = top;
  feature.through = false;
  const Tolerances& tol = options.tol;
  for (const double place : placer.places()) {
    below.target = subtract(below.target, placer.across(place, placer.half_gap(place) + kBeforeTab), tol);
    below.allowed = subtract(below.allowed, placer.across(place, options.tabs.width / 2), tol);
  }
  below.profile->tabs = std::move(tabs);
  return below;
}

/// Ends a profile above the underside of the material.
void leave_skin(Feature& feature, double skin, Diagnostics& diagnostics) {
  const double floor = feature.floor_z + feature.profile->beyond + skin;
  if (floor >= feature.top_z)
    throw InputError("--skin", trimmed(skin, 3) + " mm is as thick as the profile " + feature.name +
                                   " is deep; make it thinner");
  feature.floor_z = floor;
  feature.profile->beyond = 0;
  feature.through = false;
  diagnostics.note(feature.name,
                   "a skin of " + trimmed(skin, 3) + " mm is left under it, which holds what it surrounds");
}

}  // namespace

void shape_profiles(Part& part, const PlanOptions& options, StepSources& sources) {
  std::vector<Workingstep> workplan;
  for (const Workingstep& step : part.workplan) {
    workplan.push_back(step);
    Feature& feature = part.features[static_cast<std::size_t>(step.feature)];
    if (!feature.profile) continue;
    if (options.tabs.skin && feature.profile->side != ProfileSide::kOn)
      leave_skin(feature, *options.tabs.skin, part.diagnostics);
    const double radius = tool_of(part, step).radius();
    // What is left for finishing counts on both sides of the kerf.
    const double finish = options.shop.finish ? options.shop.finish_stock.value_or(kFinishStock) : 0;
    const double stock = step.operation.allowance_side + finish;
    shape(feature, part, radius, stock, options.tol);
    const bool held = options.tabs.count > 0 && feature.profile->side != ProfileSide::kOn;
    auto below = held ? split_at_tabs(feature, radius, stock, part, options) : std::nullopt;
    if (!below) continue;
    Workingstep lower = step;
    lower.name = below->name;
    lower.operation.name = below->name;
    lower.feature = static_cast<int>(part.features.size());
    part.features.push_back(*std::move(below));
    sources[step_key(lower)] = sources[step_key(step)];
    workplan.push_back(std::move(lower));
  }
  part.workplan = std::move(workplan);
}

}  // namespace clearcut::resolve
