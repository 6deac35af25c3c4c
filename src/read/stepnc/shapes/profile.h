// Profiles of ISO 14649-10: closed outlines, open outlines, cross-sections swept along a path; travel paths.
#pragma once

#include "read/stepnc/shapes/curve.h"

namespace clearcut::read::stepnc {

/// A closed profile's outline, placed by the profile's own placement (argument 0) when `placed`.
/// GENERAL_CLOSED_PROFILE, CIRCULAR_, RECTANGULAR_ and NGON_CLOSED_PROFILE.
Loop closed_profile(const Node& profile, bool placed, Context& context);
bool is_closed_profile(const Node& profile);
/// Does the profile bring a placement of its own that moves it?
bool has_own_placement(const Node& profile);

/// An open profile lying in plan (walls of open pockets, outside profiles): GENERAL_PROFILE, LINEAR_PROFILE,
/// PARTIAL_CIRCULAR_PROFILE, SQUARE_U_PROFILE of no depth as a line.
Path open_profile(const Node& profile, Context& context);

/// What a cross-section, swept along a path, amounts to.
struct CrossSection {
  double width = 0;            ///< mm at the top
  double draft = 0;            ///< radians from vertical, both sides
  double fillet = 0;           ///< mm; between floor and sides
  double rounded_below = 0;    ///< mm above the lowest point from where the sides are no longer prismatic
  double undercut_width = 0;   ///< mm; of a T slot at its floor; 0: none
  double undercut_height = 0;  ///< mm
  std::optional<double>
      vee;  ///< radians between the sides of a section that comes to a point; then the depth says how wide it is
};
/// Throws InputError for sections that no upright cutter makes (general; vees
/// that lean or have a rounded point; undercuts that are no box).
CrossSection cross_section(const Node& profile, Context& context);

/// A travel path in plan: LINEAR_PATH, GENERAL_PATH, PARTIAL_CIRCULAR_PATH, COMPLETE_CIRCULAR_PATH.
Path travel_path(const Node& path, Context& context);

}  // namespace clearcut::read::stepnc
