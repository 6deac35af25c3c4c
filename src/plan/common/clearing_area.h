// Splits a layer into the legal area of the cutter's centre, the passes along its walls, and the part of the target
// left by these passes: every strategy that fills an area begins with this split. A finishing pass along every wall.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "model/clearing_area.h"
#include "model/layer.h"

namespace clearcut::plan {

/// Splits a layer into wall passes and rest.
///
/// Shape   One wall pass for each boundary of the legal area: closed, or on layers with open sides the open
///         stretches from which the target can be reached. Then a pass on each line on which the cutter just fits.
///         Empty if the cutter fits nowhere.
/// Error   Parts of the target neither in a rest nor within the tool radius of a wall pass cannot be reached, to 2
///         um.
/// Cost    O(n log n) for n edges of the layer's outlines.
ClearingArea clearing_area(const Layer& layer, const Tolerances& tol);

/// Whether the layer is a pocket closed all round. The target is inside `allowed`, so the two are compared by area.
bool closed_all_round(const Layer& layer);

/// Radians; engagement of a cutter of `radius` mm along a straight wall of which it takes `stock` mm.
double engagement_along_wall(double radius, double stock);

/// Radians; greatest engagement of a pass along the walls of `area` by a cutter of `radius` mm that takes `stock` mm: in a corner between two
/// walls it cuts the stock of both at once, its turn more than along a straight wall; inside an arc hardly wider than itself as much.
double engagement_along_walls(const Regions& area, double radius, double stock);

/// A closed pass on each boundary of the legal area, tool_radius + wall_stock off the wall and oriented as
/// contours are, and a pass on each line on which the cutter just fits. Costs one offset.
LayerPasses plan_walls(const Layer& layer, const Tolerances& tol);

}  // namespace clearcut::plan
