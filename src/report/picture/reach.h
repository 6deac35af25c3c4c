// What a cutter can reach of a floor, for pictures: where its centre may be, and its width.
#pragma once

#include <vector>

#include "model/part.h"
#include "report/picture/plan_picture.h"

namespace clearcut::report {

struct Reach {
  double diameter = 0;  ///< of the smallest cutter that worked on the feature, or was meant to; 0: none
  double flat = 0;      ///< of the flat of its end, which alone cuts down to the floor
  Regions centers;      ///< legal positions of its centre at the floor
  std::vector<Path> fit_lines;   ///< and where it just fits,
  std::vector<Vec2> fit_points;  ///< along lines or in a single point (a drill in its hole)
};

/// mm; how wide a cutter is `above` mm over its tip. Holes end in the cone of a drill: theirs is as wide as it is.
double width_on_floor(const Feature& feature, const Tool& tool, double above);

/// Cost: one Clearance of the feature's allowed area.
Reach reach_of(const Job& job, int feature);

/// The outlines at the floor: smaller than those at the top where walls have draft.
Regions floor_target(const Feature& feature);
Regions floor_allowed(const Feature& feature);

}  // namespace clearcut::report
