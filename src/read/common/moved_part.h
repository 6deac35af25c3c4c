// A part in coordinates with another zero.
#pragma once

#include <array>
#include <string>

#include "model/part.h"
#include "options/job_file.h"

namespace clearcut::read {

/// "corner", "centre", or "X,Y,Z" in mm or with units. Throws InputError at `place`.
ZeroPoint parse_zero_point(const std::string& text, const std::string& place = "--origin");

/// The zero in the coordinates of the part, mm: the corner with the lowest x and y, or the middle, at the top of its
/// block; of its outlines if no block is stated.
std::array<double, 3> zero_of(const Part& part, const ZeroPoint& zero);

/// Subtracts `zero` from all places of the part: outlines, depths, stock, clamps, holes, the height of rapids.
Part with_zero_at(Part part, const std::array<double, 3>& zero);

/// A part placed elsewhere in the plane.
struct PlanPlacement {
  bool turned = false;  ///< a quarter turn to the left about the zero, before it is moved
  Vec2 by;              ///< mm

  Vec2 placed(Vec2 p) const { return (turned ? Vec2{-p.y, p.x} : p) + by; }
};

/// All places of the part: outlines, stock, clamps, holes, stated paths.
Part with_placement(Part part, const PlanPlacement& placement);

}  // namespace clearcut::read
