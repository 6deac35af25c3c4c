// Outlines in the form of the papers: lengths of the sides and interior angles between them.
//
// Source and symbols (CPO-kappa section II and algorithm 1, CPO-rho appendix A):
//
//   paper     here                    unit   meaning
//   L_0j      Side::length            mm     length of side j
//   alpha_j   Side::angle             rad    interior angle at its end, above pi if the corner is reflex
//   r_j       Side::radius            mm     of the arc rounding that corner, 0: a sharp corner
//   (x0, y0)  SideList::start         mm     start of the first side
//   theta     SideList::orientation   rad    direction of the first side; the papers begin along +x and turn
#pragma once

#include <vector>

#include "geometry/region.h"

namespace clearcut::inline geometry {

struct Side {
  /// mm; straight length between the beginnings of the arcs at its corners.
  double length = 0;
  double angle = 0;
  double radius = 0;
};

/// The material is on the left of every side.
struct SideList {
  Vec2 start;  ///< start of the straight part of the first side
  double orientation = 0;
  std::vector<Side> sides;
};

/// Length between a corner and the beginning of its arc: r |cot(alpha / 2)|, mm.
double tangent_length(const Side& corner);
/// CPO-rho appendix A: L_arc = r (pi - alpha), taken as positive at reflex corners. mm.
double arc_length(const Side& corner);
/// Difference of the sum of the angles from (N - 2) pi, rad.
double angle_excess(const SideList& list);

/// The sides and arcs one after the other, as they are: the end of the last misses the start by the closing
/// error. At least one side.
Path traced(const SideList& list);
/// Vector from the end of the last edge to the start of the first, mm: zero if the list closes.
Vec2 closing_error(const Path& trace);
/// The loop of a nearly closed trace. The closing error is distributed along the trace as in surveying (the compass
/// rule), so that no edge turns by more than the error over its length.
Loop closed_by_compass_rule(const Path& trace);

}  // namespace clearcut::inline geometry
