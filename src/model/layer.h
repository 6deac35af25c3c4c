// Input of every strategy: one layer of one feature with its cutter.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/tolerances.h"
#include "geometry/box.h"
#include "geometry/region.h"
#include "model/part.h"
#include "model/pass.h"

namespace clearcut::inline model {

struct Layer {
  double z_top = 0;        ///< height of the top of the material
  double z = 0;            ///< height of the cutter's tip
  Regions target;          ///< material to remove, plan view at z
  Regions allowed;         ///< area in which the cutter may be at z; its boundary is the true walls
  double tool_radius = 0;  ///< radius of the flat part of the cutter's end, mm
  double wall_stock = 0;   ///< stock to leave on walls and the round of the cutter's corners, mm
  /// mm; part of wall_stock due to the corner rounding of the cutter: above the rounding its side cuts.
  double rounded = 0;
  /// mm; part of wall_stock needed only for rounding in the program: exact fits need not keep this part.
  double reserve = 0;
  std::optional<Box> stock;  ///< plan view of the stock; no material outside. Absent: unlimited material
  /// Holes at least as deep as the layer, through which the cutter can go down.
  std::vector<PredrilledHole> holes;
  double lift = 10;  ///< mm from the tip up to the height of rapids across, mean of the feature's layers
  /// Rapids of later cuts descend here: not even a residual far thinner than tol.uncut may stay.
  bool bare = false;
};

/// A strategy as its callers see it.
using Strategy = std::function<LayerPasses(const Layer&)>;

}  // namespace clearcut::inline model
