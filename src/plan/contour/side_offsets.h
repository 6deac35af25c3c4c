// Contours by formula, from lengths and angles only, as the papers compute them. Kept apart from the
// geometric offsets, so that each can be checked against the other.
//
// Source and symbols (CPO-kappa eq. 2, alg. 2 and 3; CPO-rho appendix B; docs/texts.md):
//
//   paper     here                     unit   meaning
//   H, F      step                     mm     from one contour to the next; R + e for the first
//   L_ij      Side::length             mm     straight length of side j of contour i
//   alpha_j   Side::angle              rad    interior angle at its end
//   r_j       Side::radius             mm     of the arc there; shrinks by H in convex corners
//   s                                         sides of a run that vanish together: s + 1 angles become one,
//                                             alpha_1 + ... + alpha_(s+1) - s pi
//   gamma                              rad    pi - alpha at the ends of a vanished side: its neighbours are
//                                             prolonged to their intersection by L sin(gamma) / sin(alpha)
//
// Departures: CPO-rho prints the length beyond a vanished arc with one r cot(alpha / 2); here both corners
// have a term of their own. The formulas do not cover splitting contours, nor an arc with a neighbour vanishing
// before the arc: both are reported as kBeyond.
#pragma once

#include <vector>

#include "base/elementary.h"
#include "geometry/side_list.h"

namespace clearcut::plan::contour {

/// Shape of contours at reflex corners.
enum class ReflexCorners {
  kMitred,  ///< sharp, as in the papers: sides are prolonged to their intersections
  kRounded  ///< by an arc about the corner, as in Minkowski offsets: r grows by H from 0
};

/// Whether there is a next contour.
enum class SideOffsetEnd {
  kContour,  ///< there is a next contour
  kGone,     ///< all sides have vanished
  kBeyond    ///< not covered by the formulas: a rounded or reflex corner at a vanishing side
};

struct SideOffset {
  SideOffsetEnd end = SideOffsetEnd::kGone;
  SideList contour;
  int vanished = 0;  ///< number of vanished sides
};

/// The next contour, `step` mm inside the closed contour `list`. Splits and crossings are not noticed. Cost
/// O(n^2) at worst.
SideOffset offset_sides(const SideList& list, double step, ReflexCorners corners);

/// The lengths of all contours as CPO-kappa sums them (eq. 1 and 3).
struct PublishedLength {
  std::vector<SideList> contours;
  std::vector<double> levels;   ///< mm from the wall
  std::vector<double> lengths;  ///< mm, straight sides and arcs
  std::vector<double> angles;   ///< rad, smallest convex angle of each contour
  double passages = 0;  ///< mm, M = H / sin(alpha / 2) between contours, along the smallest angle's bisector
  double total = 0;     ///< mm
  bool beyond = false;  ///< the formulas failed before the centre was reached
};

/// The lengths of all contours for a cutter of `radius` mm and `allowance` mm on the wall. `step` returns the
/// mm to the next contour for a smallest angle in radians. Alg. 3 is not applied.
template <typename Step>
PublishedLength published_length(const SideList& outline, double radius, double allowance, Step step);

/// mm; straight sides and arcs.
double length_of(const SideList& list);
/// Radians; the smallest angle below pi between straight sides, rounded corners left out; pi if there is
/// none.
double smallest_angle(const SideList& list);

template <typename Step>
PublishedLength published_length(const SideList& outline, double radius, double allowance, Step step) {
  PublishedLength result;
  double inwards = radius + allowance, level = inwards;
  auto next = offset_sides(outline, inwards, ReflexCorners::kMitred);
  while (next.end == SideOffsetEnd::kContour) {
    const SideList& contour = next.contour;
    result.levels.push_back(level);
    result.lengths.push_back(length_of(contour));
    result.angles.push_back(smallest_angle(contour));
    result.contours.push_back(contour);
    result.total += result.lengths.back();
    inwards = step(result.angles.back());
    level += inwards;
    next = offset_sides(contour, inwards, ReflexCorners::kMitred);
    if (next.end == SideOffsetEnd::kContour) result.passages += inwards / base::sin(result.angles.back() / 2);
  }
  result.beyond = next.end == SideOffsetEnd::kBeyond;
  result.total += result.passages;
  return result;
}

}  // namespace clearcut::plan::contour
