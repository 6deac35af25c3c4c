// A second opinion on one layer: cuts a raster and looks at what is left. Shares no code with the verifier,
// and errs on one side only: what it calls a fault is one, beyond any doubt of the raster's.
#pragma once

#include <span>
#include <vector>

#include "geometry/region.h"
#include "model/move.h"

namespace clearcut::test_support {

struct RasterFindings {
  int uncut_cells = 0;  ///< certainly reachable, certainly not cut
  double uncut_mm2 = 0;
  Vec2 uncut_at;           ///< the place farthest from every cut
  double uncut_depth = 0;  ///< mm from there to the nearest cut
  double gouge = 0;        ///< mm, exact: deepest reach of a move beyond the wall
  Vec2 gouge_at;
  int rapid_cells = 0;  ///< cells of material that a rapid runs through
  double reachable_mm2 = 0;
};

struct RasterJob {
  Regions target;     ///< material of the layer
  Regions allowed;    ///< where the cutter may be
  double radius = 0;  ///< of the cutter, mm
  double wall_stock = 0;
  double z_top = 0;
  double z = 0;
  double cell = 0.1;  ///< mm
};

/// Simulates all moves in order; those at the layer's z (or ending there) cut.
RasterFindings simulate(const RasterJob& job, std::span<const Move> moves);

}  // namespace clearcut::test_support
