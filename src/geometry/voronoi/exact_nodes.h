// The exact places of a diagram's nodes: its builder knows sites on a grid and arcs as tangents only.
#pragma once

#include "geometry/voronoi/diagram.h"

namespace clearcut::inline geometry::voronoi {

/// Moves each inside node to where its elements are equally far, by damped least squares, and sets its clearance. Elements of
/// nodes for which that fails are put among diagram.doubtful.
void correct_nodes(Diagram& diagram);

}  // namespace clearcut::inline geometry::voronoi
