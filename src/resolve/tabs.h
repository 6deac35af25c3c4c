// Tabs in the kerfs of profiles: where they stand, and the layers between them.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::resolve {

/// Places that were asked for, mm, by the index of the feature whose outline they are nearest to.
using PlacesByFeature = std::map<int, std::vector<Vec2>>;

/// Gives each of options.at to the nearest profile that cuts something free. Throws InputError for a place that is farther than 5 mm
/// from all of them.
PlacesByFeature places_of_tabs(const Part& part, const TabOptions& options);

/// What a cutter takes along a profile.
struct Kerf {
  double radius = 0;  ///< mm, of the cutter
  double width = 0;   ///< mm, of what it may take
};

/// What is asked of tabs.
struct TabWish {
  const TabOptions& options;
  const PlacesByFeature& places;
  const Tolerances& tol;
};

/// The layers of a profile below the tops of its tabs, as a feature of its own; the feature itself keeps those above. Nothing where
/// no tabs are asked for, or none fits.
///
/// Places      Straight stretches and wide arcs, away from corners and from the kerfs of other sides: spread evenly, or where they
///             were asked for.
/// Square      The cutter has no room in the tab: passes end beside it.
/// Triangular  The kerf goes on under them, for passes rise over them (link/sections/over_tabs.h).
///
/// Throws InputError where no place is left for a tab of an outer profile or for one that was asked for by its place; says so in
/// part.diagnostics for inner profiles.
std::optional<Feature> split_at_tabs(Part& part, int feature, const Kerf& kerf, const TabWish& wish);

}  // namespace clearcut::resolve
