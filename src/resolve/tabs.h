// Tabs in the kerfs of profiles: their places, and the layers between them.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::resolve {

/// Requested places, mm, by the index of the feature with the nearest outline.
using PlacesByFeature = std::map<int, std::vector<Vec2>>;

/// Whether the profile, which goes through the material, frees the part itself, and not waste inside the part: an
/// outer profile, or a closed followed line outside of all profiles and other such lines.
bool frees_part(const Feature& feature, const Part& part);

/// Gives each of options.at to the nearest of the profiles `through` the material that can have tabs. Throws
/// InputError for a place farther than 5 mm from all of them.
PlacesByFeature places_of_tabs(const Part& part, const TabOptions& options, const std::set<int>& through);

/// The cut along a profile.
struct Kerf {
  double radius = 0;  ///< mm; radius of the cutter
  double width = 0;   ///< mm; width of the permitted cut
};

/// The line of a profile, which may cross the line of another profile.
struct OtherLine {
  int feature = 0;
  Path line;
  double floor_z = 0;
  double reach = 0;                     ///< mm; greatest distance of its cut from the line
  ProfileSide side = ProfileSide::kOn;  ///< side of the cut; for kOn the cutter's centre follows the line
};

/// Request for tabs.
struct TabWish {
  const TabOptions& options;
  const PlacesByFeature& places;
  const std::vector<OtherLine>& lines;  ///< lines of all features: a tab crossed by one of them would be cut
  const Tolerances& tol;
};

/// The layers of a profile below the tops of its tabs, as a separate feature; the feature itself keeps the layers
/// above. Nothing if no tab fits, or if the kerf of an inside profile covers its whole inside.
///
/// Places      Straight stretches and wide arcs, away from corners, from the kerfs of other sides and of other
///             profiles, and from crossing lines: spread evenly, or at the requested places.
/// Square      The cutter has no room in the tab: passes end beside it.
/// Triangular  The kerf continues below them, since passes rise over the tabs (link/sections/high_rapids.h).
///
/// Throws InputError if no place is left for a tab of a profile that frees the part, or for a tab requested by its
/// place; reports other missing tabs in part.diagnostics.
std::optional<Feature> split_at_tabs(Part& part, int feature, const Kerf& kerf, const TabWish& wish);

}  // namespace clearcut::resolve
