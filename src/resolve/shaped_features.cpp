#include "resolve/shaped_features.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "features/derived_outlines.h"
#include "features/round_hole.h"
#include "features/standing.h"
#include "features/tool_choice.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"
#include "model/cutter_profile.h"
#include "resolve/features/shaping.h"
#include "resolve/resolve.h"
#include "resolve/tabs.h"
#include "resolve/values/cutting_values.h"

namespace clearcut::resolve {
namespace {

/// mm. Floors narrower than this beyond the mill's diameter are left to the bit.
constexpr double kRoom = 0.01;

double widest_clearance(const Regions& regions, const Tolerances& tol) {
  double widest = 0;
  for (const Region& region : regions) widest = std::max(widest, Clearance(region, tol).max());
  return widest;
}

/// Largest fitting mill that clears floors; -1 for none.
int floor_mill(const Feature& feature, const std::vector<Tool>& tools, const Tolerances& tol) {
  const double fits = features::largest_fitting_diameter(feature, tol) - kRoom;
  int best = -1;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const bool flat = mills_upright(tools[i]) && tools[i].kind != ToolKind::kBallEndMill;
    if (!flat || tools[i].diameter > fits) continue;
    if (best < 0 || tools[i].diameter > tools[static_cast<std::size_t>(best)].diameter)
      best = static_cast<int>(i);
  }
  return best;
}

bool has_mill(const std::vector<Tool>& tools) {
  return std::any_of(tools.begin(), tools.end(), [](const Tool& tool) { return mills_upright(tool); });
}

std::string size_of(const Tool& bit) {
  return fmt::format("T{} ({} {} deg, {} mm)", bit.number, name_of(bit.kind),
                     trimmed(bit.tip_angle->degrees(), 3), trimmed(bit.diameter, 4));
}

[[noreturn]] void refuse_without_mill(const Feature& feature, const Tool& bit, double widest) {
  throw InputError(
      feature.name,
      fmt::format("it is up to {} mm wide and {} reaches its walls down to {} mm: the floor between them "
                  "needs an end mill; give one besides, for example --tool endmill:3{}",
                  trimmed(2 * widest, 3), size_of(bit), trimmed(feature.top_z - feature.floor_z, 3),
                  feature.carving->limit ? ", or allow more depth" : ", or a wider bit"));
}

/// Depth of the bit in the feature: down to its limit, to the bit's full width, or to the depth required by the
/// widest place.
double depth_of(const Feature& feature, const Tool& bit, double widest) {
  const double asked = (widest - bit.tip_diameter / 2) / flank_slope(bit);
  return std::min({asked, flank_height(bit), feature.carving->limit.value_or(asked)});
}

void shape_carving(Feature& feature, const Tool& bit, double widest) {
  if (widest <= bit.tip_diameter / 2) {
    throw InputError(feature.name, fmt::format("the tip of {} is {} mm wide and fits nowhere into it; use a "
                                               "bit with a smaller tip",
                                               size_of(bit), trimmed(bit.tip_diameter, 4)));
  }
  feature.wall_slope = Radians::of(bit.tip_angle->radians() / 2);
  feature.floor_z = feature.top_z - depth_of(feature, bit, widest);
}

/// A plug for an inlay: its outline is as drawn at `start` below the top, so that its walls, inclined outwards, are
/// farther in at the top. At the border of the carved area, the area is not widened beyond the permitted area.
void widen_to_start(Feature& feature, const Tool& bit, const Tolerances& tol) {
  const double start = feature.carving->start;
  if (start <= 0) return;
  if (feature.carving->limit && *feature.carving->limit <= start)
    throw InputError(
        feature.name,
        fmt::format("it is carved {} mm deep and its outline is as drawn at {} mm: carve deeper, "
                    "as in VCARVE_START1_D2.5",
                    trimmed(*feature.carving->limit, 3), trimmed(start, 3)));
  feature.target = feature.allowed = dilate(feature.target, start * flank_slope(bit), tol);
}

Workingstep floor_step(const Workingstep& step, int mill, const Part& part, const PlanOptions& options,
                       StepSources& sources) {
  Workingstep out = step;
  out.stated_path.reset();
  out.name += "_floor";
  out.operation.name = out.name;
  sources[step_key(out)] = sources[step_key(step)];
  change_tool(out.operation, mill, part, options);
  return out;
}

/// Gives the feature the groove of a shaped cutter along a line.
void shape_groove(Feature& feature, const Tool& tool) {
  const double depth = feature.top_z - feature.floor_z;
  if (is_conical(tool) && depth > flank_height(tool)) {
    throw InputError(feature.name,
                     fmt::format("it is {} mm deep and the flanks of {} end {} mm above its tip; "
                                 "use less depth or a wider bit",
                                 trimmed(depth, 3), size_of(tool), trimmed(flank_height(tool), 3)));
  }
  const double radius = radius_at(tool, depth);
  const Tolerances tol;
  feature.target = features::kerf_of(*feature.profile, 2 * radius, tol);
  feature.allowed = features::kerf_of(*feature.profile, 2 * (radius + kBesideLine), tol);
  if (is_conical(tool)) feature.wall_slope = Radians::of(tool.tip_angle->radians() / 2);
}

}  // namespace

void shape_carvings(Part& part, const PlanOptions& options, StepSources& sources) {
  std::vector<Workingstep> workplan;
  for (const Workingstep& step : part.workplan) {
    Feature& feature = part.features[static_cast<std::size_t>(step.feature)];
    const Tool& tool = tool_of(part, step);
    if (feature.carving && !is_conical(tool))
      throw InputError(feature.name, "V-carving needs a V-bit; give one, for example --tool vbit:60deg:6");
    if (feature.carving) {
      widen_to_start(feature, tool, options.tol);
      const double widest = widest_clearance(feature.target, options.tol);
      shape_carving(feature, tool, widest);
      const double floor_from = tool.tip_diameter / 2 + (feature.top_z - feature.floor_z) * flank_slope(tool);
      if (widest > floor_from + options.tol.fit) {
        if (!has_mill(part.tools)) refuse_without_mill(feature, tool, widest);
        const int mill = floor_mill(feature, part.tools, options.tol);
        if (mill >= 0) workplan.push_back(floor_step(step, mill, part, options, sources));
      }
    } else if (!feature.chamfer && is_carved(feature, tool)) {
      shape_groove(feature, tool);
    }
    workplan.push_back(step);
  }
  part.workplan = std::move(workplan);
}

namespace {

/// mm. The same for cutters of any size.
constexpr double kToolSpare = 0.01;
/// mm. Stock on walls for finishing if none is stated.
constexpr double kFinishStock = 0.3;
/// mm2. Greatest area of specks left by a boolean of areas that only touch.
constexpr double kSpeck = 0.01;
/// Share of the cutter's radius by which the far side of the kerf may be cut too wide. More would let ramps and
/// rapids leave the contour into the material beside it.
constexpr double kBeyondKerf = 0.02;
/// Distance around a profile, in radii of the cutter, in which others are searched.
constexpr double kBand = 3;

Regions within(const ProfileCut& cut) {
  return {Region::from_valid_loops(cut.line, {})};
}

/// The area of parts near `cut`: over all profiles from large to small, outer ones add area, inner ones subtract it.
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

/// mm across the kerf of a profile: width permitted to its cutter, with stock left for finishing on both sides. A
/// followed line has no such stock.
double allowed_width(ProfileSide side, double radius, double stock) {
  if (side == ProfileSide::kOn) return 2 * (radius + kBesideLine);
  return (2 + kBeyondKerf) * radius + kToolSpare + 2 * stock;
}

/// mm across the area that a profile's cutter must clear: a rounded end leaves material on the far side of its kerf
/// at the floor, and along a line on both sides; these sides are no walls of a part.
double target_width(ProfileSide side, const Tool& tool) {
  const double flat = flat_end(tool) > 0 ? flat_end(tool) : tool.radius();
  return side == ProfileSide::kOn ? 2 * flat : tool.radius() + flat;
}

void shape(Feature& feature, const Part& part, const Tool& tool, double stock, const Tolerances& tol) {
  const ProfileCut& cut = *feature.profile;
  const double radius = tool.radius();
  feature.target = features::kerf_of(cut, target_width(cut.side, tool), tol);
  feature.allowed = features::kerf_of(cut, allowed_width(cut.side, radius, stock), tol);
  if (cut.side == ProfileSide::kOn) return;
  const Regions solid = solid_around(part, cut, kBand * radius, tol);
  // Without other parts in the way the area is unchanged and exact.
  if (solid.empty() || area(intersect(feature.allowed, solid, tol)) < kSpeck) return;
  feature.target = subtract(feature.target, solid, tol);
  feature.allowed = subtract(feature.allowed, solid, tol);
}

/// Narrows the area that a round end has to clear in a profile shallower than it is high: nowhere in the profile does it come to its full
/// width, and the far side of its kerf is no wall of a part.
void narrow_to_round_end(Feature& feature, const Tool& tool, double allowance_floor, const Tolerances& tol) {
  if (feature.profile->side == ProfileSide::kOn || flat_end(tool) > 0) return;
  const double widest = radius_at(tool, feature.top_z - feature.floor_z - allowance_floor);
  if (widest >= tool.radius() - kSamePlaceMm) return;
  feature.target =
      intersect(feature.target, features::kerf_of(*feature.profile, tool.radius() + widest, tol), tol);
}

/// Drawings may go deeper than the stock: there is no material below the stock.
void measure_beyond(Part& part) {
  if (!part.stock) return;
  for (Feature& feature : part.features) {
    if (!feature.profile) continue;
    const double below = part.stock->z_bottom - feature.floor_z;
    if (below > feature.profile->beyond + kSamePlaceMm) feature.profile->beyond = below;
  }
}

/// Followed lines are engraved, before the profiles that free the part; lines that go through may free the part
/// themselves. Therefore all features that may free a piece come last, features around a smaller area before those
/// around a larger one.
void put_lines_among_cut_outs(Part& part) {
  const auto frees = [&part](const Workingstep& step) {
    return features::may_free(feature_of(part, step), part);
  };
  const bool any_line = std::any_of(part.workplan.begin(), part.workplan.end(), [&](const Workingstep& step) {
    return frees(step) && feature_of(part, step).profile->side == ProfileSide::kOn;
  });
  if (!part.order_free || !any_line) return;
  const auto last = std::stable_partition(part.workplan.begin(), part.workplan.end(),
                                          [&](const Workingstep& step) { return !frees(step); });
  const auto within = [&part](const Workingstep& step) {
    return std::abs(signed_area(feature_of(part, step).profile->line));
  };
  std::stable_sort(last, part.workplan.end(),
                   [&](const Workingstep& a, const Workingstep& b) { return within(a) < within(b); });
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
  diagnostics.note(feature.name, "a skin of " + trimmed(skin, 3) + " mm is left under it" +
                                     (feature.profile->closed ? ", which holds what it surrounds" : ""));
}

/// Whether something goes through the material that tabs hold, or a skin.
bool holds_anything(const Part& part, const std::set<int>& through, bool by_tabs) {
  return std::any_of(part.workplan.begin(), part.workplan.end(), [&](const Workingstep& step) {
    const bool pointed = is_carved(feature_of(part, step), tool_of(part, step));
    return through.contains(step.feature) && !(by_tabs && pointed);
  });
}

/// Reports that tabs have no effect on a part without profiles, and on lines engraved into the material.
void tell_of_nothing_held(Part& part, const TabOptions& tabs, const std::set<int>& through) {
  if (tabs.any() && !holds_anything(part, through, true))
    part.idle["tabs"] = "nothing comes free of the material that end mills cut out; see --op profile:outer";
  if (tabs.skin && !holds_anything(part, through, false))
    part.idle["skin"] = "nothing comes free of the material; see --op profile:outer";
  std::string first;
  int count = 0;
  bool any_profile = false;
  for (const Workingstep& step : part.workplan) {
    any_profile = any_profile || feature_of(part, step).profile;
    if (!feature_of(part, step).profile || through.contains(step.feature)) continue;
    if (count++ == 0) first = feature_of(part, step).name;
  }
  if (!any_profile)
    part.diagnostics.warn(tabs.skin ? "--skin" : "--tabs",
                          "no outline is cut out, so " +
                              std::string(tabs.skin ? "no skin is" : "no tabs are") +
                              " left; --op profile:outer cuts the outermost outlines of a drawing out");
  if (count == 0) return;
  const std::string others = count > 1 ? "and of " + std::to_string(count - 1) + " other lines " : "";
  part.diagnostics.note(first, others + "the depth ends within the material, so nothing comes free: " +
                                   (tabs.skin ? "no skin is left" : "no tabs are left"));
}

/// Whether the profile's tool can leave tabs; if not, reports this, or throws if the line frees the part itself.
bool can_leave_tabs(const Feature& feature, const Tool& tool, Part& part) {
  if (!is_carved(feature, tool)) return true;
  const std::string what =
      "tabs are left by end mills, not by the pointed or round tip of T" + std::to_string(tool.number);
  if (part.stock && frees_part(feature, part))
    throw InputError(feature.name,
                     what +
                         "; it goes through the material, and what it surrounds comes loose: give "
                         "an end mill (--tool), or leave a skin (--skin)");
  part.diagnostics.warn(feature.name, what + "; none are left in it");
  return false;
}

/// Skins and tabs that each step leaves below its profile or in its kerf to hold the freed piece.
class Holds {
 public:
  Holds(Part& part, const PlanOptions& options)
      : part_(part), options_(options), through_(features::profiles_through(part)) {
    if (options.tabs.any() || options.tabs.skin) tell_of_nothing_held(part, options.tabs, through_);
    if (!options.tabs.any()) return;
    places_ = places_of_tabs(part, options.tabs, through_);
    for (const Workingstep& step : part.workplan) {
      const Feature& feature = feature_of(part, step);
      if (!feature.profile) continue;
      const double radius = tool_of(part, step).radius();
      const bool on = feature.profile->side == ProfileSide::kOn;
      lines_.push_back({step.feature, feature.profile->line, feature.floor_z, on ? radius : 2 * radius,
                        feature.profile->side});
    }
  }

  /// Ends the profile of `step` above the underside if a skin is requested.
  void leave_skin(const Workingstep& step) const {
    if (options_.tabs.skin && through_.contains(step.feature))
      resolve::leave_skin(part_.features[static_cast<std::size_t>(step.feature)], *options_.tabs.skin,
                          part_.diagnostics);
  }

  /// The layers between tabs, if there are tabs.
  std::optional<Feature> split(const Workingstep& step, const Kerf& kerf) const {
    if (!options_.tabs.any() || !through_.contains(step.feature)) return std::nullopt;
    if (!can_leave_tabs(feature_of(part_, step), tool_of(part_, step), part_)) return std::nullopt;
    return split_at_tabs(part_, step.feature, kerf, {options_.tabs, places_, lines_, options_.tol});
  }

 private:
  Part& part_;
  const PlanOptions& options_;
  std::set<int> through_;
  PlacesByFeature places_;
  std::vector<OtherLine> lines_;
};

/// The slot of a followed line is as wide as its cutter.
void leave_nothing_beside_lines(const Feature& feature, Workingstep& step, StepSources& sources) {
  if (feature.profile->side != ProfileSide::kOn || step.operation.allowance_side == 0) return;
  step.operation.allowance_side = 0;
  sources[step_key(step)].set("allowance", {Origin::kDerived, "the slot of a line is as wide as its cutter"});
}

/// The tops of all features if profiles were declared at the top of the part.
std::vector<double> tops_from_above(Part part, const Tolerances& tol) {
  for (Feature& feature : part.features) {
    if (feature.profile) feature.top_z = part.top_z();
  }
  return features::stacked_tops(part, tol);
}

/// Heights of the material over profiles that earlier features have lowered: over their outlines (`before`), and over
/// the kerfs of their cutters, which may reach beyond what the earlier features have cleared.
class TopsOfKerfs {
 public:
  TopsOfKerfs(const Part& part, const Tolerances& tol) : tol_(tol) {
    const bool any = std::any_of(part.features.begin(), part.features.end(), [&](const Feature& feature) {
      return feature.profile && feature.top_z < part.top_z() - kSamePlaceMm;
    });
    if (any) before_ = tops_from_above(part, tol);
  }

  /// Raises the tops of lowered profiles to the highest material over their kerfs.
  void raise(Part& part) const {
    if (before_.empty()) return;
    const std::vector<double> over_kerfs = tops_from_above(part, tol_);
    for (std::size_t i = 0; i < before_.size(); ++i) {
      Feature& feature = part.features[i];
      if (feature.profile && std::abs(before_[i] - feature.top_z) < kSamePlaceMm)
        feature.top_z = std::max(feature.top_z, over_kerfs[i]);
    }
  }

 private:
  const Tolerances& tol_;
  std::vector<double> before_;
};

/// The layers above tabs end at their tops, without additional stock on them.
void leave_tabs_as_high_as_asked(Workingstep& above, StepSources& sources) {
  if (above.operation.allowance_floor == 0) return;
  above.operation.allowance_floor = 0;
  sources[step_key(above)].set("allowance-floor", {Origin::kDerived, "tabs are as high as they are asked"});
}

bool is_accepted(const PlanOptions& options, std::string_view condition) {
  return std::find(options.accept.begin(), options.accept.end(), condition) != options.accept.end();
}

/// Without a stated stock nobody knows whether a profile goes through; where one does, nothing holds what it cuts out.
void tell_of_loose_parts(Part& part, const PlanOptions& options) {
  const auto frees = [&](const Feature& feature) {
    return feature.profile && feature.through && feature.profile->side == ProfileSide::kOutside &&
           feature.profile->tabs.empty();
  };
  const auto found = std::find_if(part.features.begin(), part.features.end(), frees);
  if (part.stock || found == part.features.end() || is_accepted(options, "loose-part")) return;
  part.diagnostics.note(found->name,
                        "no stock is stated; where the profile goes through it, nothing holds what is cut "
                        "out: leave tabs (--tabs 3) or a skin (--skin 0.3), or hold it otherwise");
}

}  // namespace

void shape_profiles(Part& part, const PlanOptions& options, StepSources& sources) {
  put_lines_among_cut_outs(part);
  measure_beyond(part);
  const Holds holds(part, options);
  const TopsOfKerfs tops(part, options.tol);
  std::vector<Workingstep> workplan;
  for (const Workingstep& step : part.workplan) {
    workplan.push_back(step);
    Feature& feature = part.features[static_cast<std::size_t>(step.feature)];
    if (!feature.profile) continue;
    leave_nothing_beside_lines(feature, workplan.back(), sources);
    holds.leave_skin(step);
    const double radius = tool_of(part, step).radius();
    // Stock for finishing counts on both sides of the kerf.
    const double finish = options.shop.finish ? options.shop.finish_stock.value_or(kFinishStock) : 0;
    const double stock = workplan.back().operation.allowance_side + finish;
    shape(feature, part, tool_of(part, step), stock, options.tol);
    auto below = holds.split(step, {radius, allowed_width(feature.profile->side, radius, stock)});
    if (!below) continue;
    Workingstep lower = workplan.back();
    lower.name = below->name;
    lower.operation.name = below->name;
    lower.feature = static_cast<int>(part.features.size());
    part.features.push_back(*std::move(below));
    sources[step_key(lower)] = sources[step_key(step)];
    leave_tabs_as_high_as_asked(workplan.back(), sources);
    workplan.push_back(std::move(lower));
  }
  part.workplan = std::move(workplan);
  tops.raise(part);
  for (const Workingstep& step : part.workplan) {
    Feature& feature = part.features[static_cast<std::size_t>(step.feature)];
    if (feature.profile)
      narrow_to_round_end(feature, tool_of(part, step), step.operation.allowance_floor, options.tol);
  }
  tell_of_loose_parts(part, options);
}

void put_what_frees_last(Part& part) {
  const auto line_of = [&part](const Workingstep& step) -> const Path& {
    return feature_of(part, step).profile->line;
  };
  const auto last = std::stable_partition(
      part.workplan.begin(), part.workplan.end(),
      [&part](const Workingstep& step) { return !features::may_free(feature_of(part, step), part); });
  for (auto first = last; first != part.workplan.end();) {
    const Path line = line_of(*first);
    first = std::stable_partition(first, part.workplan.end(),
                                  [&](const Workingstep& step) { return line_of(step) == line; });
  }
}

}  // namespace clearcut::resolve
