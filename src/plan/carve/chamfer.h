// Chamfers: the tip of a cone runs beside a wall so that its flank breaks the wall's edge.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "geometry/region.h"
#include "model/part.h"
#include "plan/carve/carve.h"

namespace clearcut::plan::carve {

/// Shape and depths of a cone breaking an edge. Lengths in mm.
struct ChamferShape {
  double top = 0;          ///< height of the wall's top
  double slope = 0;        ///< mm of radius that the flanks gain for each mm of height
  double tip_radius = 0;   ///< radius of the flat at the tip
  double tool_radius = 0;  ///< radius at the upper end of the flanks
  double aside = 0;        ///< distance kept from the chamfer, for rounding
  double stepdown = 0;     ///< greatest increase of depth from one pass to the next
};

/// In plan view, there is material outside of `free` up to the height `z`, mm.
struct StandingUpTo {
  double z = 0;
  Regions free;
};

struct ChamferTracks {
  TrackSets sets;
  double left_mm = 0;  ///< mm of the edge left out, because the cone would gouge there
};

/// The axis runs beside the wall at the cone's radius at the height of the chamfer's foot. The tip is below the foot,
/// by up to 0.5 mm if there is room, so that the flank cuts and not the tip. If the cone would gouge another wall, or
/// material above the edge, the tip goes less deep; if it would gouge nevertheless, this stretch of the edge is left
/// out.
///
/// Cost O(length of the edge * edges of the remaining material).
ChamferTracks chamfer_edge(const Chamfer& chamfer, const ChamferShape& shape,
                           const std::vector<StandingUpTo>& standing, const Tolerances& tol);

}  // namespace clearcut::plan::carve
