// Tours: a grid of legal centres, ordered by an optimiser, and passes along the walls; square lattices of points to
// visit in a box; the entry in the table of strategies.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/tolerances.h"
#include "geometry/box.h"
#include "geometry/route/legal_area.h"
#include "model/layer.h"
#include "model/options/strategy_entry.h"

namespace clearcut::plan::tour {

using Points = std::vector<Vec2>;

/// Rows and columns of points, `pitch` mm apart, from the lower left one at `corner`.
struct Lattice {
  Vec2 corner;
  double pitch = 0;
  int columns = 0, rows = 0;

  Vec2 at(int column, int row) const { return corner + Vec2{column * pitch, row * pitch}; }
};

/// The lattice from the box's lower left corner, as published.
Lattice published_lattice(const Box& box, double pitch);
/// A lattice of at most `largest` mm pitch, reduced so that rows meet both ends of the box's longer side;
/// centred along the other side. For a box far smaller than the pitch, only its middle.
Lattice fitted_lattice(const Box& box, double largest);
/// The same lattice with as many more columns and rows as fill `box`.
Lattice filling(const Lattice& lattice, const Box& box);
/// The points of the lattice in `area`, row by row.
Points points_in(const Lattice& lattice, const LegalArea& area);

/// The corners of the shortest legal path between two points, given by index; empty if the straight move is
/// legal.
using PathFunction = std::function<std::vector<Vec2>(int from, int to)>;

/// The problem for the optimiser: an open path through all points, with free ends.
struct TourTask {
  std::vector<Vec2> points;
  PathFunction path;  ///< may be called from several threads
  const Layer* layer = nullptr;
  double pitch = 0;  ///< pitch of the grid, mm
};

/// Returns the order of visits, each point once. The pipeline passes this function in, with the requested search.
using TourSolver = std::function<std::vector<int>(const TourTask&)>;

struct TourGridOptions {
  /// Pitch of the grid: a share of the diameter (Tour eq. 4.8: the engagement) or mm. Up to 0.7 diameters the whole
  /// area of the grid is cleared with any order; places left by wider grids are visited in addition.
  double pitch = 0.9;
  bool pitch_in_mm = false;
  /// As published: the grid begins at the boundary of the legal area, on open sides a radius beyond the target (7.6),
  /// and no other passes are cut, so that a rim is left.
  bool published = false;
};

/// Reads the pitch as "0.5" (share of the diameter) or "3.5mm". Throws InputError.
TourGridOptions parse_tour_grid(const std::string& text);

/// Plans the passes of one layer.
///
/// Grid    A square lattice fitted to the longer side of each connected legal area. Kept are its points well
///         inside and, nearer to walls, the points clearing places that neither other points nor wall passes clear.
/// Shape   For each connected legal area an open pass through the grid in the solver's order, illegal moves
///         replaced by their shortest legal path, and the wall passes around it; passes on lines on which the cutter
///         just fits. Empty if the cutter fits nowhere.
/// Error   Nothing reachable of `target` is left: places left by the passes are found exactly and visited in addition
///         (unless `published`).
/// Cost    The solver's, and O(points * neighbours).
/// Source  Tour 3.3.4, 4.2.4; departures in docs/tour.md.
LayerPasses plan_tour(const Layer& layer, const TourGridOptions& options, const TourSolver& solve,
                      const Tolerances& tol);

/// `solver_for` makes the search for the order of the grid's points.
StrategyEntry entry(std::function<TourSolver(const StrategyRequest&)> solver_for);

}  // namespace clearcut::plan::tour
