// All offsets of a diagram at given distances: closed runs of pieces, one piece a cell, and the exact lines and arcs
// made of them.
#pragma once

#include <optional>
#include <vector>

#include "geometry/region.h"
#include "geometry/voronoi/diagram.h"

namespace clearcut::inline geometry::voronoi {

/// The part of a level's curve in the cells of one element. The piece starts on the bisector with the previous piece,
/// between the places `low` and `high` of that bisector, near `guess`.
struct Piece {
  int element = 0;
  Vec2 guess;
  Vec2 low;
  Vec2 high;
  bool at_node = false;  ///< the bisector ends before reaching the level exactly: the piece starts at `guess`
  bool mended = false;   ///< previous pieces were dropped: the joint may be off the bisector
  std::optional<Vec2> joint;  ///< start of the piece, once solved
};

/// Closed; the material at this depth is on the left. Neighbouring pieces are of different elements, except a single
/// piece forming a full circle.
struct LevelCurve {
  int level = 0;
  std::vector<Piece> pieces;
};

/// The numbers of all edges that a curve at `level` mm, or farther inside, may cut, ascending. `margin` as below.
/// O(edges): one list serves all deeper levels, which few edges reach where an outline has many vertices.
std::vector<int> edges_reaching(const Diagram& diagram, double level, double margin);

/// Curves at the ascending distances `levels` (mm, > 0), ordered by level. A node belongs to a level if its clearance
/// exceeds the level by `margin`: the same for all, so that widths of twice a level within rounding give no curve.
/// `reaching`: edges_reaching of the first level or of one before it. O(reaching + pieces).
std::vector<LevelCurve> level_curves(const Diagram& diagram, const std::vector<int>& reaching,
                                     const std::vector<double>& levels, double margin);

/// Loop at distance d from the elements: lines stay parallel, arcs concentric, corners become arcs; joints
/// are the intersections of neighbouring offset curves. `slack` (mm) is the greatest distance of the diagram from the
/// exact boundary; pieces that exist only within this distance are dropped. Nothing if no area is left.
std::optional<Loop> offset_loop(const Diagram& diagram, const LevelCurve& curve, double d, double slack);

}  // namespace clearcut::inline geometry::voronoi
