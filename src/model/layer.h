// What every strategy takes: one layer of one feature with its cutter.
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
  double z_top = 0;        ///< where material begins
  double z = 0;            ///< where the tip runs
  Regions target;          ///< material to remove, plan view at z
  Regions allowed;         ///< where the cutter may be at z; true walls are its boundary
  double tool_radius = 0;  ///< of the flat part of the cutter's end, mm
  double wall_stock = 0;   ///< stock to leave on walls and the round of the cutter's corners, mm
  double rounded = 0;      ///< mm; of wall_stock, the round of the cutter's corners: above it the side cuts
  double reserve =
      0;  ///< mm; of wall_stock, what only rounding of the program asks for: exact fits need not keep it
  std::optional<Box> stock;           ///< plan view; beside it there is nothing. Absent: material without end
  std::vector<PredrilledHole> holes;  ///< as deep as the layer: ways down
  double lift = 10;  ///< mm from the tip up to where rapids cross, in the mean of the feature's layers
  /// Rapids of what is cut later come down through here: not even a residual far thinner than tol.uncut may stay.
  bool bare = false;
};

/// What a strategy is to those who run it.
using Strategy = std::function<LayerPasses(const Layer&)>;

}  // namespace clearcut::inline model
