// Chamfers: the tip of a cone runs beside a wall so that its flank breaks the wall's edge.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "geometry/region.h"
#include "model/part.h"
#include "plan/carve/carve.h"

namespace clearcut::plan::carve {

/// How a cone breaks an edge. Lengths in mm.
struct ChamferShape {
  double top = 0;          ///< of the wall
  double slope = 0;        ///< mm that the flanks go outwards for each mm upwards
  double tip_radius = 0;   ///< of the flat at the tip
  double tool_radius = 0;  ///< where the flanks end
  double aside = 0;        ///< mm that the flank stays off the chamfer: what rounding may take
  double stepdown = 0;     ///< most that one pass goes deeper than the one before
};

/// What stands up to `z` beside `free`, in plan view.
struct StandingUpTo {
  double z = 0;
  Regions free;
};

struct ChamferTracks {
  TrackSets sets;
  double left_mm = 0;  ///< length of the edge where the cone would cut what is to stay
};

/// Along the wall at the distance of the cone's radius at the chamfer's foot; the tip goes below the foot as far as room allows,
/// so that the flank cuts and not the tip. Where the cone would touch what stands on the other side of the room, or above
/// the edge, the tip stays higher, and if that does not help the stretch is left out.
///
/// Cost O(length of the edge * edges of what stands).
ChamferTracks chamfer_edge(const Chamfer& chamfer, const ChamferShape& shape,
                           const std::vector<StandingUpTo>& standing, const Tolerances& tol);

}  // namespace clearcut::plan::carve
