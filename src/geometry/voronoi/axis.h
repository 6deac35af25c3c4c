// The medial axis, its peaks, and the parts of it on which a cutter just fits: its clearance there is the cutter's
// radius.
#pragma once

#include <vector>

#include "geometry/voronoi/clearance.h"
#include "geometry/voronoi/diagram.h"

namespace clearcut::inline geometry::voronoi {

/// Elements on both sides of an axis edge.
struct Walls {
  int a = 0;
  int b = 0;
};

struct Axis {
  MedialAxis graph;
  std::vector<Walls> walls;                ///< walls of each edge of the graph
  std::vector<std::vector<int>> incident;  ///< edges at each point of the graph
};

/// The diagram inside the region, without edges that only separate one wall from itself or from its smooth
/// continuation; coincident nodes become one. A point without edges is the centre of a round pocket.
Axis make_axis(const Diagram& diagram);

/// Local maxima that rise more than `prominence` above every path along the axis to a higher place; the middle of a
/// plateau. Largest first.
std::vector<AxisPoint> find_centers(const Axis& axis, const Diagram& diagram, double prominence);

/// Range of clearances in which a cutter of `radius` just fits: from `low` to below `high`. mm.
struct FitBand {
  double low = 0;
  double radius = 0;
  double high = 0;
};

/// Curves of the axis with clearance in the band, except mouths of wider places and ends in corners: dead ends
/// shorter than `stub` mm are removed if their clearance is below the radius. A place with room for only one position
/// becomes a point: a path of one edge with from == to.
std::vector<Path> fit_lines(const Axis& axis, const Diagram& diagram, const FitBand& band, double stub);

}  // namespace clearcut::inline geometry::voronoi
