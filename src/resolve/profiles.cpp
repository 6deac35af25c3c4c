#include "resolve/profiles.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text/format.h"
#include "geometry/boolean.h"
#include "geometry/clearance.h"
#include "resolve/tabs.h"
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

/// Whether an outer profile surrounds the line, so that what the line cuts free is no part of its own.
bool lies_in_a_part(const ProfileCut& cut, const Part& part) {
  return std::any_of(part.features.begin(), part.features.end(), [&cut](const Feature& feature) {
    return feature.profile && feature.profile->side == ProfileSide::kOutside &&
           contains(feature.profile->line, cut.line.front().from);
  });
}

/// Tabs that are asked for and cannot be left: a line that is followed is engraved all along. Throws where the line frees the
/// part itself.
void tell_of_missing_tabs(const Feature& feature, const TabOptions& tabs, Part& part) {
  if (!tabs.any() || feature.profile->side != ProfileSide::kOn) return;
  const std::string what =
      "tabs are left in profiles alone, not along lines that the cutter's centre follows";
  const bool through = part.stock && feature.floor_z <= part.stock->z_bottom;
  if (!through || !feature.profile->closed) return part.diagnostics.warn(feature.name, what);
  const std::string loose = what + "; it goes through the material, and what it surrounds comes loose";
  if (lies_in_a_part(*feature.profile, part)) return part.diagnostics.warn(feature.name, loose);
  throw InputError(feature.name, loose +
                                     ": cut it beside the line (--op profile, drawn larger by half the "
                                     "cutter), or leave a skin (less depth)");
}

}  // namespace

void shape_profiles(Part& part, const PlanOptions& options, StepSources& sources) {
  const PlacesByFeature places = places_of_tabs(part, options.tabs);
  std::vector<Workingstep> workplan;
  for (const Workingstep& step : part.workplan) {
    workplan.push_back(step);
    Feature& feature = part.features[static_cast<std::size_t>(step.feature)];
    if (!feature.profile) continue;
    tell_of_missing_tabs(feature, options.tabs, part);
    if (options.tabs.skin && feature.profile->side != ProfileSide::kOn)
      leave_skin(feature, *options.tabs.skin, part.diagnostics);
    const double radius = tool_of(part, step).radius();
    // What is left for finishing counts on both sides of the kerf.
    const double finish = options.shop.finish ? options.shop.finish_stock.value_or(kFinishStock) : 0;
    const double stock = step.operation.allowance_side + finish;
    shape(feature, part, radius, stock, options.tol);
    const Kerf kerf{radius, allowed_width(radius, stock)};
    auto below = split_at_tabs(part, step.feature, kerf, {options.tabs, places, options.tol});
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
