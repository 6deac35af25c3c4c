// Tours: a grid of legal centres, put in order by an optimiser, with a pass along the walls.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/tolerances.h"
#include "model/layer.h"
#include "model/pass.h"

namespace clearcut::plan::tour {

/// The bends of the shortest legal path between two points by index; empty when the straight move is legal.
using PathFunction = std::function<std::vector<Vec2>(int from, int to)>;

/// What the optimiser is asked: an open path through all points, with free ends.
struct TourTask {
  std::vector<Vec2> points;
  PathFunction path;  ///< may be called from several threads
  const Layer* layer = nullptr;
  double pitch = 0;  ///< of the grid, mm
};

/// The order of visits, each point once. Another stage's business; handed in by the pipeline.
using TourSolver = std::function<std::vector<int>(const TourTask&)>;

struct TourGridOptions {
  /// Of the grid: a share of the diameter (Tour eq. 4.8: the engagement) or mm. At 0.7 diameters every place
  /// of the grid is cleared whatever the order; wider grids are mended.
  double pitch = 0.9;
  bool pitch_in_mm = false;
  /// As published: the grid begins at the boundary of the legal area and nothing else is cut. Leaves a rim.
  bool published = false;
};

/// Options with the pitch as "0.5" (share of the diameter) or "3.5mm". Throws InputError.
TourGridOptions parse_tour_grid(const std::string& text);

/// The passes of one layer.
///
/// Grid    a square lattice stretched to fit the wider way of each connected legal area. Kept are its points
///         well inside and, nearer to walls, those that clear what neither others nor the walls' passes do.
/// Shape   for each connected legal area an open pass through the grid in the solver's order, illegal moves
///         replaced by their shortest legal path, and the rings along the walls that surround it; passes where
///         the cutter just fits. Empty where the cutter has no legal position.
/// Error   nothing reachable of `target` is left: what the passes leave is found exactly and visited on the
///         way (unless published).
/// Cost    the solver's, and O(points * neighbours).
/// Source  Tour 3.3.4, 4.2.4; departures in docs/tour.md.
LayerPasses plan_tour(const Layer& layer, const TourGridOptions& options, const TourSolver& solve,
                      const Tolerances& tol);

}  // namespace clearcut::plan::tour
