// Tabs in the kerfs of profiles: where they stand, and the layers between them.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::resolve {

/// Places that were asked for, mm, by the index of the feature whose outline they are nearest to.
using PlacesByFeature = std::map<int, std::vector<Vec2>>;

/// Whether the profile, which goes through the material, cuts the part itself free, and no waste within it: an outer profile, or
/// a closed line that is followed and lies in none, nor in another such line.
bool frees_part(const Feature& feature, const Part& part);

/// Gives each of options.at to the nearest profile of those that go `through` the material and can have tabs. Throws InputError for
/// a place that is farther than 5 mm from all of them.
PlacesByFeature places_of_tabs(const Part& part, const TabOptions& options, const std::set<int>& through);

/// What a cutter takes along a profile.
struct Kerf {
  double radius = 0;  ///< mm, of the cutter
  double width = 0;   ///< mm, of what it may take
};

/// The line of a profile, which may cross that of another.
struct OtherLine {
  int feature = 0;
  Path line;
  double floor_z = 0;
  double reach = 0;                     ///< mm; no farther beside it anything is cut
  ProfileSide side = ProfileSide::kOn;  ///< on which that is; the cutter's centre follows lines that it is on
};

/// What is asked of tabs.
struct TabWish {
  const TabOptions& options;
  const PlacesByFeature& places;
  const std::vector<OtherLine>& lines;  ///< of all features: a tab that one of them crosses would be cut
  const Tolerances& tol;
};

/// The layers of a profile below the tops of its tabs, as a feature of its own; the feature itself keeps those above. Nothing where
/// no tab fits, and where the kerf of an inside profile takes all that it surrounds.
///
/// Places      Straight stretches and wide arcs, away from corners, from the kerfs of other sides and of other profiles, and from
///             lines that cross: spread evenly, or where they were asked for.
/// Square      The cutter has no room in the tab: passes end beside it.
/// Triangular  The kerf goes on under them, for passes rise over them (link/sections/over_tabs.h).
///
/// Throws InputError where no place is left for a tab of a profile that frees the part or for one that was asked for by its place;
/// says so in part.diagnostics for others.
std::optional<Feature> split_at_tabs(Part& part, int feature, const Kerf& kerf, const TabWish& wish);

}  // namespace clearcut::resolve
