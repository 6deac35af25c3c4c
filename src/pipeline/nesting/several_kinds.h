// Places of rectangles of several sizes on a rectangular sheet, some of them turned by 90 degrees.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/box.h"
#include "geometry/vec2.h"

namespace clearcut::pipeline {

/// The rectangle as it is not turned, mm.
struct NestKind {
  double width = 0, height = 0;
  std::optional<int> count;  ///< absent: as many as fit beside those of all counts
};

/// Lengths in mm.
struct KindsQuestion {
  double width = 0, height = 0;  ///< of the sheet
  double edge = 0;               ///< of the sheet, that stays free
  double gap = 0;                ///< between two rectangles, and between one and what is kept free
  std::vector<NestKind> kinds;
  std::vector<Box> kept_free;  ///< on the sheet
};

/// Where the lower left corner of one lies, mm from that of the sheet.
struct KindPlace {
  std::size_t kind = 0;
  Vec2 at;
  bool turned = false;
};

/// The best of some greedy layouts by maximal free rectangles. Kinds with a count come first; then those without one, one of each kind
/// after the other, as long as any fits. A layout that has a place for each kind is better than one that has none for some; then the
/// one in which fewer of those that are counted are missing, then more of the others are placed, then less of the sheet is taken.
/// Neighbours follow each other.
///
/// Bound   none: another layout may hold more.
/// Source  [jylanki2010] MAXRECTS: the rules "best short side fit", "best long side fit", "bottom left".
/// Cost    O(n f) for each layout, of n places and f free rectangles; at most kMostCopies places.
std::vector<KindPlace> nest_kinds(const KindsQuestion& question);

}  // namespace clearcut::pipeline
