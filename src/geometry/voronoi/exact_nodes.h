// The exact places of a diagram's nodes: the builder sees only sites on a grid and arcs as tangents.
#pragma once

#include "geometry/voronoi/diagram.h"

namespace clearcut::inline geometry::voronoi {

/// Moves each inside node to the place equally far from its elements, by damped least squares, and sets its
/// clearance. If this fails, the elements of the node are added to diagram.doubtful.
void correct_nodes(Diagram& diagram);

}  // namespace clearcut::inline geometry::voronoi
