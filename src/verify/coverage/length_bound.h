// Lower bound of the length of paths that clear an area with a disc.
#pragma once

#include "geometry/region.h"
#include "model/results/length_bound.h"

namespace clearcut::verify {

/// The area, the disc and the kind of paths. Lengths in mm.
struct LengthBoundQuestion {
  Regions area;
  double radius = 0;
  bool closed = false;  ///< the path, then one, returns to its start
  int paths = 1;
  /// mm2 of the area that need not be cleared, wherever it is. If it is not 0, nothing but the area counts.
  double left_out_mm2 = 0;
};

/// A lower bound of the length of all paths together, at least 0.
///
/// Symbols  R radius of the disc; T area to be cleared, |.| area; k number of paths; L their length; N area swept by the
///          disc along the paths, so that T is within N; S = |T| + the sum of the points' shares.
/// Without rings
///          |N| <= 2 R L + k pi R^2: the front half of the disc sweeps no more than its diameter. A closed path of
///          L >= 2 pi R even has |N| <= 2 R L, and a shorter one |N| <= pi (L / 2 pi + R)^2: crossings are avoided by
///          another order and by pulling the path apart a little; around the simple closed curve the outer parallel
///          curve at distance r has a length of at most L + 2 pi r, the inner one of at most L - 2 pi r up to the
///          inner radius q [nagy1959], and the integral over r up to R and up to min(R, q) is the area. With
///          |N| >= S: L >= (S - k pi R^2) / 2 R; closed, L >= S / 2 R if S >= 4 pi R^2, else 2 pi (sqrt(S / pi) - R).
/// Points   |N| >= S. Each point v of T is cleared from a place c of the path, within R of v. Of the disc around c the
///          part outside T belongs to N, too. Of this only the part in the cell of v counts: the places nearer to v than
///          to any other point. Cells do not overlap, so these parts can be added. The share of v is the least of
///          this part over all c within R of v.
/// Rings    One path only. The discs D(w, p) of the rings, radius p > R around a point w of T, do not overlap. To come
///          within R of w, a closed path that also leaves D(w, p) runs at least 2 (p - R) within D(w, p), in and out.
///          What it clears from there lies within D(w, p + R), whose part of T is the area of the ring. Everything
///          else of N is swept by the rest of the path at 2 R a mm at most: each stretch of the rest begins on the
///          circle of a ring, where the whole disc lies in D(w, p + R). So
///          L >= 2 x the sum of (p - R) + (S - the areas of the rings) / 2 R, without the second term if negative. Cells
///          of points end at the tangent of D(w, p + R) square to the line from w to the point. An open path begins and
///          ends somewhere: in a ring it may leave out one crossing, p - R; elsewhere the first disc, pi R^2 / 2 R.
///          At most one of the two ends can leave out the disc, and not both the same ring's crossing.
///          The path leaves each D(w, p) because some of T is farther than p + R from w.
/// Error    Shares are too small by at most 0.01 R^2, never too large. Curves count as chords, and the area between
///          is subtracted from the shares and added to the areas of rings.
LengthBound length_bound(const LengthBoundQuestion& question);

/// The sum: the bound in mm for the radius, area, points and rings of `bound`; its `mm` is not used.
double added_up(const LengthBound& bound);

}  // namespace clearcut::verify
