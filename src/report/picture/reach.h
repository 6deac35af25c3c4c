// What a cutter can reach of a floor, for pictures: where its centre may be, and its width.
#pragma once

#include <vector>

#include "model/part.h"
#include "report/picture/plan_picture.h"

namespace clearcut::report {

struct Reach {
  double diameter = 0;  ///< of the smallest cutter that worked on the feature, or was meant to; 0: none
  Regions centers;      ///< legal positions of its centre at the floor
  std::vector<Path> fit_lines;   ///< and where it just fits,
  std::vector<Vec2> fit_points;  ///< along lines or in a single point (a drill in its hole)
};

/// Cost: one Clearance of the feature's allowed area.
Reach reach_of(const Job& job, int feature);

/// The outlines at the floor: smaller than those at the top where walls have draft.
Regions floor_target(const Feature& feature);
Regions floor_allowed(const Feature& feature);

}  // namespace clearcut::report
