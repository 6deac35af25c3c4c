// From a feature and an operation to the layers that the strategies plan.
#pragma once

#include <vector>

#include "model/layer.h"
#include "model/part.h"

namespace clearcut::plan {

/// The heights of the tip, descending, from `top_z` to exactly `floor_z` in steps of at most `stepdown`.
///
/// Every layer is `stepdown` deep and the last takes the rest, as asked for; when that rest would be a sliver
/// under 5 % of the step, all layers are made equal instead (as many, none deeper than `stepdown`). Empty
/// when floor_z >= top_z. Throws InputError for a stepdown that is not positive or would need over 10 000
/// layers.
std::vector<double> layer_heights(double top_z, double floor_z, double stepdown);

/// The layers of `feature` cut by `operation` with a tool of `tool_radius` mm, from the top down.
///
/// Depth ends at floor_z + allowance_floor. Absent stepdown: tool_radius (half the diameter). With leaning
/// walls each layer has the outline at its own depth, so that no layer cuts into the wall, and the stepdown
/// is lowered so that the steps left on the wall stand no more than `operation.scallop` mm off it, square to
/// the wall: scallop = stepdown * sin(slope) (SPEC B4). Layers whose outline has vanished (walls with draft that
/// met) are left out.
///
/// A cutter with rounded corners cuts the floor with the flat part of its end only: it is planned as one that
/// much narrower which keeps that much farther from walls. `stock_above`, mm: what earlier work has left to stand over
/// the feature's top; the first layer begins there. (Ball ends have no flat part and are planned as if
/// flat.)
std::vector<Layer> layers_of(const Feature& feature, const Operation& operation, double tool_radius,
                             const Tolerances& tol, double corner_radius = 0, double stock_above = 0);

/// Whether the outlines are the same, edge by edge.
bool same_outline(const Regions& a, const Regions& b);

/// Plans layer after layer; what differs from the layer before in height alone gets its passes, at its own depth.
Strategy once_per_outline(Strategy plan);

}  // namespace clearcut::plan
