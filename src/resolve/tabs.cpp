#include "resolve/tabs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::resolve {
namespace {

/// mm. Kerfs end this much before the cutter's widest place beside a tab.
constexpr double kBeforeTab = 0.02;
/// mm. Greatest height of tabs without a stated height.
constexpr double kTabHeight = 2;
/// Default height of tabs as a share of the depth.
constexpr double kTabShare = 0.5;
/// mm along the outline between places tested for a tab.
constexpr double kTabSearch = 0.5;
/// mm. Greatest distance of requested places from an outline.
constexpr double kBesideOutline = 5;
/// Least number of tabs if only their spacing is given: a single tab would let the piece swing.
constexpr int kLeastOfSpacing = 2;

/// A stretch of one edge of the outline.
struct Stretch {
  std::size_t edge = 0;
  double from = 0;  ///< mm from the edge's start
  double to = 0;
};

/// mm to the left of the outline.
struct Across {
  double from = 0;
  double to = 0;
};

/// Position of the kerf of `width`: for outer profiles it is on the right of their counter-clockwise outline.
Across across_kerf(ProfileSide side, double width) {
  switch (side) {
    case ProfileSide::kOutside:
      return {-width, 0};
    case ProfileSide::kInside:
      return {0, width};
    case ProfileSide::kOn:
      return {-width / 2, width / 2};
  }
  return {};
}

/// mm; length of a tab along the outline at the profile's floor, for a tab of `height` over the material's underside.
/// The sides of triangular tabs continue below the underside.
double foot_of(const TabOptions& options, double height, double beyond) {
  return options.shape == TabShape::kSquare ? options.width : options.width * (height + beyond) / height;
}

/// The base of a tab.
struct Foot {
  double length = 0;  ///< mm along the outline
  /// Passes end beside the tab; else they rise over it, with room for the rise before the next corner.
  bool is_level = true;
};

class TabPlacer {
 public:
  /// `others`: lines of other features that tabs must avoid.
  TabPlacer(const ProfileCut& cut, const Kerf& kerf, const Foot& foot, std::vector<OtherLine> others)
      : cut_(cut),
        radius_(kerf.radius),
        kerf_(kerf.width),
        across_(across_kerf(cut.side, kerf.width)),
        middle_(cut.side == ProfileSide::kOutside  ? -kerf.radius
                : cut.side == ProfileSide::kInside ? kerf.radius
                                                   : 0),
        foot_(foot.length),
        corner_(foot.is_level ? kOverlap : kerf_ + kOverlap),
        others_(std::move(others)) {
    double at = 0;
    for (const Edge& edge : cut.line) {
      starts_.push_back(at);
      at += edge.length();
    }
    around_ = at;
  }

  double around() const { return around_; }

  /// Middles of `count` tabs, mm along the outline, spread as evenly as places allow; fewer if they do not fit.
  std::vector<double> evenly(int count) const {
    std::vector<double> chosen;
    for (int i = 0; i < count; ++i) {
      if (const auto place = nearest_fit(around_ * (i + 0.5) / count, chosen)) chosen.push_back(*place);
    }
    return chosen;
  }

  /// Middles of the least number of tabs with no more than `spacing` mm along the outline between neighbours. If
  /// corners prevent this: the tabs that come nearest to it.
  std::vector<double> spaced(double spacing) const {
    const int least =
        std::max(kLeastOfSpacing, static_cast<int>(std::ceil(around_ / spacing - kSamePlaceMm)));
    std::vector<double> best;
    for (int count = least; count <= 2 * least + kLeastOfSpacing; ++count) {
      std::vector<double> places = evenly(count);
      if (best.empty() || widest_gap(places) < widest_gap(best)) best = std::move(places);
      if (widest_gap(best) <= spacing + kSamePlaceMm) break;
    }
    return best;
  }

  /// mm; greatest distance along the outline between successive tabs; on open lines also to their ends.
  double widest_gap(std::vector<double> places) const {
    if (places.empty()) return std::numeric_limits<double>::infinity();
    std::sort(places.begin(), places.end());
    const double before = places.front(), behind = around_ - places.back();
    double widest = cut_.closed ? before + behind : std::max(before, behind);
    for (std::size_t i = 1; i < places.size(); ++i) widest = std::max(widest, places[i] - places[i - 1]);
    return widest;
  }

  /// mm along the outline to the place nearest to p.
  double nearest_to(Vec2 p) const {
    double at = 0, least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < cut_.line.size(); ++i) {
      const Nearest near = nearest(cut_.line[i], p);
      if (near.distance >= least) continue;
      least = near.distance;
      at = starts_[i] + near.t * cut_.line[i].length();
    }
    return cut_.closed ? std::fmod(at, around_) : at;
  }

  /// The place nearest to `wanted`, mm along the outline, at which a tab fits beside the chosen ones.
  std::optional<double> nearest_fit(double wanted, const std::vector<double>& chosen) const {
    const double most = cut_.closed ? around_ / 2 : std::max(wanted, around_ - wanted);
    for (double away = 0; away <= most; away += kTabSearch) {
      const double ahead = cut_.closed ? std::fmod(wanted + away, around_) : wanted + away;
      if (fits(ahead, chosen)) return ahead;
      const double back = cut_.closed ? std::fmod(wanted - away + around_, around_) : wanted - away;
      if (fits(back, chosen)) return back;
    }
    return std::nullopt;
  }

  Vec2 point(double middle) const {
    const Stretch on = stretch(middle, 0);
    return cut_.line[on.edge].at(std::clamp(on.from / cut_.line[on.edge].length(), 0.0, 1.0));
  }

  Tab tab(double middle) const {
    Tab tab;
    // Seen from the foot a kerf is on one side: for a followed line the foot is on the kerf's right rim.
    const bool on = cut_.side == ProfileSide::kOn;
    tab.foot = moved(piece(middle, foot_ / 2), on ? -radius_ : 0);
    tab.aside = on ? radius_ + across_.to : across_.from + across_.to;
    tab.center = middle_of_kerf(middle);
    tab.body = across(middle, foot_ / 2);
    return tab;
  }

  /// Plan view of the area that the cutter's widest part cannot enter at depth.
  Regions gap(double middle) const { return across(middle, half_gap(middle) + kBeforeTab); }

  /// Whether a tab fits: on one line, or an arc much wider than the tab, away from corners and other tabs.
  bool fits(double middle, const std::vector<double>& chosen) const {
    if (middle < 0 || middle > around_) return false;
    const double half = half_gap(middle) + kBeforeTab;
    const Stretch on = stretch(middle, half);
    const Edge& edge = cut_.line[on.edge];
    if (on.from < corner_ || on.to > edge.length() - corner_) return false;
    if (edge.is_arc() && edge.radius() < std::max(2 * half, kNarrowArc * kerf_)) return false;
    const bool apart_from_others = std::all_of(chosen.begin(), chosen.end(), [&](double other) {
      const double apart = std::abs(other - middle);
      return (cut_.closed ? std::min(apart, around_ - apart) : apart) > 2 * half + radius_;
    });
    return apart_from_others && is_free(on);
  }

 private:
  static constexpr double kOverlap = 0.01;  ///< mm
  /// Share of the kerf: radius of arcs that are too narrow to move across the kerf.
  static constexpr double kNarrowArc = 1.25;

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

  Edge piece(double middle, double half) const {
    const Stretch on = stretch(middle, half);
    const Edge& edge = cut_.line[on.edge];
    return edge.part(on.from / edge.length(), on.to / edge.length());
  }

  /// Outline's stretch of `half` mm to both sides of the middle, moved over the kerf; no farther, since the kerf of
  /// another side may be beyond it.
  Regions across(double middle, double half) const {
    const Edge own = piece(middle, half);
    // A little of the part is included, so that no sliver remains between.
    const Edge right = moved(own, across_.from - kOverlap),
               left = moved(own, across_.to + kOverlap).reversed();
    return {Region::from_valid_loops(
        {right, Edge::line(right.to, left.from), left, Edge::line(left.to, right.from)}, {})};
  }

  Vec2 middle_of_kerf(double middle) const {
    const Stretch on = stretch(middle, 0);
    const Edge& edge = cut_.line[on.edge];
    const double t = std::clamp(on.from / edge.length(), 0.0, 1.0);
    return edge.at(t) + left_of(edge.tangent_at(t)) * middle_;
  }

  /// mm along the outline, to both sides of the middle, over which the cutter's widest part cannot be at depth.
  double half_gap(double middle) const {
    const Edge& edge = cut_.line[stretch(middle, 0).edge];
    if (!edge.is_arc()) return foot_ / 2 + radius_;
    // The tab's sides point to the arc's centre; the cutter touches them from a circle about this centre.
    const double inwards = edge.turn == Turn::kCounterClockwise ? middle_ : -middle_;
    const double around = edge.radius() - (inwards > 0 ? kerf_ / 2 : inwards);
    return foot_ / 2 + edge.radius() * base::asin(std::min(1.0, radius_ / std::max(around, radius_)));
  }

  /// Whether no kerf along another side, in a notch or an acute corner, overlaps the stretch's own kerf: a tab there
  /// would be cut, and there would be no material beyond for it to hold.
  bool is_free(const Stretch& on) const {
    const Edge& own = cut_.line[on.edge];
    const double kerf = kerf_ + kOverlap;
    const Edge stretch = own.part(on.from / own.length(), on.to / own.length());
    if (!is_clear_of_others(stretch)) return false;
    const Edge far = moved(stretch, middle_ == 0 ? 0 : std::copysign(kerf, middle_));
    const Box reached = far.box().grown(kerf);
    for (std::size_t i = 0; i < cut_.line.size(); ++i) {
      const Edge& other = cut_.line[i];
      if (i != on.edge && other.box().overlaps(reached) && distance(far, other) < kerf - kSamePlaceMm)
        return false;
    }
    return true;
  }

  /// Whether the kerf of no other line overlaps the stretch's own.
  bool is_clear_of_others(const Edge& stretch) const {
    const Edge middle = moved(stretch, (across_.from + across_.to) / 2);
    return std::all_of(others_.begin(), others_.end(), [&](const OtherLine& other) {
      const double apart = kerf_ / 2 + kOverlap + (is_cut_about(other, middle) ? other.reach : 0);
      const Box near = middle.box().grown(apart);
      return std::all_of(other.line.begin(), other.line.end(), [&](const Edge& edge) {
        return !edge.box().overlaps(near) || distance(edge, middle) >= apart;
      });
    });
  }

  /// Whether the other line's kerf is on the stretch's side of that line.
  bool is_cut_about(const OtherLine& other, const Edge& stretch) const {
    if (other.side == ProfileSide::kOn || cut_.side == ProfileSide::kOn) return true;
    return contains(other.line, stretch.at(0.5)) == (other.side == ProfileSide::kInside);
  }

  const ProfileCut& cut_;
  double radius_;
  double kerf_;
  Across across_;
  double middle_;  ///< mm to the left of the outline; path of the cutter's centre
  double foot_;
  double corner_;  ///< mm between a tab's gap and the next corner
  std::vector<OtherLine> others_;
  std::vector<double> starts_;
  double around_ = 0;
};

std::string text_of(Vec2 p) {
  return trimmed(p.x, 2) + "," + trimmed(p.y, 2);
}

/// Whether the kerf along the inside of an outline covers the whole inside.
bool leaves_nothing_within(const ProfileCut& cut, const Kerf& kerf, const Tolerances& tol) {
  return cut.side == ProfileSide::kInside &&
         inset(Region::from_valid_loops(cut.line, {}), 2 * kerf.radius, tol).empty();
}

/// Middles of tabs at the requested places, mm along the outline.
std::vector<double> chosen_places(const Feature& feature, const TabPlacer& placer,
                                  const std::vector<Vec2>& asked, double width) {
  std::vector<double> chosen;
  for (const Vec2 p : asked) {
    const double wanted = placer.nearest_to(p);
    if (!placer.fits(wanted, chosen)) {
      const auto other = placer.nearest_fit(wanted, chosen);
      throw InputError("--tab-at",
                       "at " + text_of(p) + " a corner or a narrow arc of " + feature.name +
                           " or another tab is too near for one of " + trimmed(width, 2) + " mm; " +
                           (other ? "the nearest place is " + text_of(placer.point(*other))
                                  : "no other place is left: take narrower ones (--tab-width) or fewer"));
    }
    chosen.push_back(wanted);
  }
  return chosen;
}

/// Reports, or throws if the profile frees the part itself, that the request is not fully possible. If nothing is
/// left to hold the freed piece, this becomes a condition.
void refuse_or_warn(const Feature& feature, const char* option, const std::string& what,
                    const std::string& instead, bool holds_nothing, Part& part) {
  if (frees_part(feature, part)) throw InputError(option, what + instead);
  if (holds_nothing && feature.profile->closed)
    part.diagnostics.doubt(feature.name, "loose-part", what + "; what it cuts free comes loose");
  else
    part.diagnostics.warn(feature.name,
                          what + (feature.profile->closed ? "; what it cuts free is held by no more" : ""));
}

/// Middles of all tabs of a profile, mm along its outline.
std::vector<double> places_on(const Feature& feature, const TabPlacer& placer, const std::vector<Vec2>& asked,
                              const TabOptions& options, Part& part) {
  if (!options.at.empty()) return chosen_places(feature, placer, asked, options.width);
  const std::string width = trimmed(options.width, 2) + " mm";
  const int wanted = options.spacing ? kLeastOfSpacing : options.count;
  std::vector<double> places = options.spacing ? placer.spaced(*options.spacing) : placer.evenly(wanted);
  if (const int count = static_cast<int>(places.size()); count < wanted) {
    refuse_or_warn(feature, options.spacing ? "--tab-spacing" : "--tabs",
                   "only " + std::to_string(count) + " of " + std::to_string(wanted) + " tabs of " + width +
                       " fit on straight stretches and wide arcs of " + feature.name,
                   "; ask for fewer or narrower ones (--tab-width)", count == 0, part);
  } else if (options.spacing && placer.widest_gap(places) > *options.spacing + kSamePlaceMm) {
    refuse_or_warn(feature, "--tab-spacing",
                   "tabs of " + width + " on straight stretches and wide arcs of " + feature.name + " are " +
                       trimmed(std::ceil(100 * placer.widest_gap(places)) / 100, 2) + " mm apart at best",
                   "; ask for a wider spacing or narrower ones (--tab-width)", false, part);
  }
  return places;
}

}  // namespace

bool frees_part(const Feature& feature, const Part& part) {
  const ProfileCut& cut = *feature.profile;
  if (cut.side != ProfileSide::kOn) return cut.side == ProfileSide::kOutside;
  const double underside = feature.floor_z + cut.beyond + kSamePlaceMm;
  const auto surrounds = [&](const Feature& other) {
    if (!other.profile || !other.profile->closed || other.profile->line == cut.line) return false;
    const bool frees =
        other.profile->side == ProfileSide::kOutside ||
        (other.profile->side == ProfileSide::kOn && other.floor_z + other.profile->beyond <= underside);
    return frees && contains(other.profile->line, cut.line.front().from);
  };
  return cut.closed && std::none_of(part.features.begin(), part.features.end(), surrounds);
}

PlacesByFeature places_of_tabs(const Part& part, const TabOptions& options, const std::set<int>& through) {
  PlacesByFeature places;
  for (const Vec2 p : options.at) {
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (const Workingstep& step : part.workplan) {
      const Feature& feature = feature_of(part, step);
      if (!through.contains(step.feature) || is_carved(feature, tool_of(part, step))) continue;
      for (const Edge& edge : feature.profile->line) {
        const double apart = distance(edge, p);
        if (apart >= least) continue;
        least = apart;
        nearest = step.feature;
      }
    }
    if (nearest < 0)
      throw InputError(
          "--tab-at",
          "there is no profile, and no line through the material, that an end mill cuts; leave it out");
    if (least > kBesideOutline)
      throw InputError("--tab-at", text_of(p) + " is " + trimmed(least, 1) +
                                       " mm from the nearest profile, " +
                                       part.features[static_cast<std::size_t>(nearest)].name +
                                       "; name a place on its outline");
    places[nearest].push_back(p);
  }
  return places;
}

std::optional<Feature> split_at_tabs(Part& part, int index, const Kerf& kerf, const TabWish& wish) {
  Feature& feature = part.features[static_cast<std::size_t>(index)];
  const TabOptions& options = wish.options;
  if (wish.places.count(index) == 0 && leaves_nothing_within(*feature.profile, kerf, wish.tol))
    return std::nullopt;
  const double under = feature.floor_z + feature.profile->beyond;
  const double height = options.height.value_or(std::min(kTabHeight, kTabShare * (feature.top_z - under)));
  const double top = under + height;
  if (top >= feature.top_z) {
    throw InputError("--tab-height", trimmed(height, 3) + " mm is as high as the profile " + feature.name +
                                         " is deep; make it lower");
  }
  std::vector<OtherLine> others;
  for (const OtherLine& line : wish.lines)
    if (line.feature != index && line.floor_z < top - kSamePlaceMm) others.push_back(line);
  const TabPlacer placer(
      *feature.profile, kerf,
      {foot_of(options, height, feature.profile->beyond), options.shape == TabShape::kSquare},
      std::move(others));
  const auto asked = wish.places.find(index);
  const std::vector<double> places = places_on(
      feature, placer, asked == wish.places.end() ? std::vector<Vec2>{} : asked->second, options, part);
  if (places.empty()) return std::nullopt;
  Feature below = feature;
  below.name = feature.name + "_tabs";
  below.top_z = top;
  for (const double place : places) {
    Tab tab = placer.tab(place);
    tab.shape = options.shape;
    tab.top_z = top;
    tab.bottom_z = feature.floor_z;
    below.target = subtract(below.target, placer.gap(place), wish.tol);
    if (tab.shape == TabShape::kSquare) below.allowed = subtract(below.allowed, tab.body, wish.tol);
    below.profile->tabs.push_back(std::move(tab));
  }
  feature.floor_z = top;
  feature.through = false;
  return below;
}

}  // namespace clearcut::resolve
