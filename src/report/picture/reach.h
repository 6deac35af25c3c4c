// Area of a floor within a cutter's reach, for pictures: the legal area of its centre, and its width.
#pragma once

#include <vector>

#include "model/part.h"
#include "report/picture/plan_picture.h"

namespace clearcut::report {

struct Reach {
  /// Diameter of the smallest cutter that worked on the feature, or was planned for it; 0: none.
  double diameter = 0;
  double flat = 0;  ///< diameter of the flat of its end, the only part that cuts down to the floor
  Regions centers;  ///< legal positions of its centre at the floor
  std::vector<Path> fit_lines;   ///< lines on which the cutter just fits,
  std::vector<Vec2> fit_points;  ///< along lines or in a single point (a drill in its hole)
};

/// mm; width of a cutter `above` mm over its tip. For holes ending in the cone of a drill, the drill's full width.
double width_on_floor(const Feature& feature, const Tool& tool, double above);

/// Cost: one Clearance of the feature's allowed area.
Reach reach_of(const Job& job, int feature);

/// The outlines at the floor: smaller than at the top if walls have draft.
Regions floor_target(const Feature& feature);
Regions floor_allowed(const Feature& feature);

}  // namespace clearcut::report
