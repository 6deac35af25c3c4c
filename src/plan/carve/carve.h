// V-carving and engraving: lines in space for the tip of a cutter that cuts by its own shape.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "geometry/region.h"
#include "model/pass.h"

namespace clearcut::plan::carve {

/// How a cone carves. Lengths in mm.
struct CarveShape {
  double top = 0;         ///< of the material
  double floor = 0;       ///< no deeper than this
  double slope = 0;       ///< mm that the flanks go outwards for each mm upwards
  double tip_radius = 0;  ///< of the flat at the tip
  double aside = 0;       ///< mm that flanks stay inside the outline: what rounding and chords may take
  double arcs_aside = 0;  ///< mm that rings on the floor stay off besides: arcs are rounded more
  double stepdown = 0;    ///< most that one pass goes deeper than the one before
  double cusp = 0;        ///< highest ridge that may stay between passes on the floor
};

/// Tracks that belong together: each set is cut before the next.
using TrackSets = std::vector<std::vector<Track>>;

/// Along the medial axis, where the cone touches the outline on both sides; at the floor along the outline's offset and, where
/// nothing of `cleared` (what a mill clears of the floor before) lies, side by side over the floor as far as the cusp allows.
///
/// Method  On the axis the tip runs at top - (clearance - tip_radius - aside) / slope. The cones there are the largest
///         within the outline, so that together they cut every place as deep as any cone may, corners included.
/// Error   chords of the axis and rounding stay within `aside`.
/// Cost    that of the Voronoi diagram, and the points of its curves for each stepdown.
TrackSets carve_region(const Region& region, const CarveShape& shape, const Regions& cleared,
                       const Tolerances& tol);

/// Along a line at the floor, in as many passes as the stepdown asks for.
TrackSets engrave_line(const Path& line, bool closed, double top, double floor, double stepdown);

}  // namespace clearcut::plan::carve
