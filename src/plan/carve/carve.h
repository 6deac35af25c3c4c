// V-carving and engraving: lines in space for the tip of a cutter whose own shape makes the cut, along stretches of
// the medial axis as polylines with the clearance at each point.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "geometry/region.h"
#include "geometry/voronoi/clearance.h"
#include "model/layer.h"

namespace clearcut::plan::carve {

/// A stretch of the axis. Between two successive points the clearance (mm) changes linearly.
using Chain = std::vector<AxisPoint>;

/// The point at the share t of the line from a to b, with the clearance there.
AxisPoint part_way(const AxisPoint& a, const AxisPoint& b, double t);

/// The parts of a chain whose clearance is from `low` to `high` mm. A chain of one point is kept or dropped as a
/// whole.
std::vector<Chain> between(const Chain& chain, double low, double high);

/// The same chain with a point added wherever its clearance passes through `clearance` mm.
Chain with_points_at(const Chain& chain, double clearance);

/// Joins chains at common ends into few longer ones, greedily: not always the fewest. Cost O(n log n).
std::vector<Chain> joined(std::vector<Chain> chains);

/// Shape and depths of a carving cone. Lengths in mm.
struct CarveShape {
  double top = 0;         ///< height of the material
  double floor = 0;       ///< height of the floor; the tip never goes below
  double slope = 0;       ///< mm of radius that the flanks gain for each mm of height
  double tip_radius = 0;  ///< radius of the flat at the tip
  double aside = 0;       ///< distance kept from the outline, for rounding and chords
  double arcs_aside = 0;  ///< additional distance of rings on the floor, for rounding of arcs
  double stepdown = 0;    ///< greatest increase of depth from one pass to the next
  double cusp = 0;        ///< highest ridge permitted between passes on the floor
};

/// Groups of tracks: each set is cut completely before the next.
using TrackSets = std::vector<std::vector<Track>>;

/// V-carving: the tip follows the medial axis, on which the cone touches the outline on both sides. In places where
/// the floor is reached the tip follows the outline's offset, then rings side by side as far apart as the cusp
/// allows, outside of `cleared` (cut by a mill).
///
/// Method  On the axis the tip runs at top - (clearance - tip_radius - aside) / slope. The cones there are the
///         largest within the outline, so that together they cut every place as deep as any permitted cone, corners
///         included.
/// Error   No gouge, if chords of the axis and rounding of the program stay within `aside`.
/// Cost    that of the Voronoi diagram, plus for each stepdown the number of points on its curves.
TrackSets carve_region(const Region& region, const CarveShape& shape, const Regions& cleared,
                       const Tolerances& tol);

/// Engraving: the tip follows the line down to `floor`, in passes no more than `stepdown` mm deeper than the last.
TrackSets engrave_line(const Path& line, bool closed, double top, double floor, double stepdown);

}  // namespace clearcut::plan::carve
