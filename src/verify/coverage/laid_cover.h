// Proves that lines of constant width cover a region, and measures what they cover more than once.
#pragma once

#include <optional>
#include <vector>

#include "base/tolerances.h"
#include "geometry/edge.h"
#include "geometry/region.h"
#include "verify/coverage/coverage.h"

namespace clearcut::verify {

struct LaidQuestion {
  Regions region;           ///< to be covered, and not to be left
  double width = 0;         ///< mm; of the line: a disc of this diameter moves along its middle
  std::vector<Path> lines;  ///< middles of the lines, each laid without a break
};

struct LaidCover {
  Coverage cover;
  double laid_mm = 0;
  double covered_mm2 = 0;  ///< lower bound: the region without what is unreachable or may be bare
  double over_mm2 = 0;     ///< upper bound of the area laid over what is covered already
  double outside_mm = 0;   ///< greatest distance of the line's edge beyond the region; 0 if it stays inside
  std::optional<Vec2> outside_at;
};

/// Symbols  r half of the width; L length of all lines; k their number; N(p) number of times that the disc comes to the place p.
/// Cover    by coverage_of().
/// Over     The area over which the disc comes, each time counted, is k pi r^2 + 2 r L exactly: the first disc of every line, and then the front
///          half of the disc enters 2 r of area for every mm, however the line turns. Without the area that is covered at all this is the sum
///          of N - 1: what is laid twice counts once, what is laid three times counts twice, the seam where a closed line ends included.
/// Outside  Distance of the lines from the region's boundary, and the side on which they begin; exact.
/// Error    of covered_mm2 that of Coverage: residuals thinner than tol.uncut count as covered, unreachable corners are
///          estimated.
/// Cost     as coverage_of().
LaidCover laid_cover_of(const LaidQuestion& question, const Tolerances& tol);

}  // namespace clearcut::verify
