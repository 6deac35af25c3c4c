// Cuts a feature into the layers that the strategies plan.
#pragma once

#include <vector>

#include "model/layer.h"
#include "model/part.h"

namespace clearcut::plan {

/// The heights of the tip, mm, from the top down: from `top_z` to exactly `floor_z` in steps of at most
/// `stepdown`.
///
/// Every layer is `stepdown` deep and the last takes the rest. If that rest is less than 5 % of the step, all
/// layers are made equally deep instead, as many as before without the last. Empty for floor_z >= top_z.
/// Throws InputError for a stepdown that is not positive or that asks for more than 10 000 layers.
std::vector<double> layer_heights(double top_z, double floor_z, double stepdown);

/// The end of a cutter beside its flat part.
struct RoundedEnd {
  double round = 0;            ///< mm; radius of the rounding; that of the cutter for balls
  bool touches_walls = false;  ///< leaning walls, over its tip; else it keeps off them as a flat end has to
};

/// The layers of `feature` cut by `operation` with a tool of `tool_radius` mm, from the top down.
///
/// The lowest layer is at floor_z + allowance_floor. Without a stepdown, it is tool_radius (half the
/// diameter). Under walls with draft each layer has the outline at its own depth, so that no layer cuts into
/// the wall, and the stepdown is lowered until the steps on the wall stand at most `operation.scallop` mm off
/// it, square to the wall: scallop = stepdown * sin(draft) for flat ends. Layers so deep that their outline has vanished
/// (with draft the area becomes smaller with depth, until the walls of opposite sides
/// meet) are left out.
///
/// A cutter with rounded corners cuts the floor with the flat part of its end alone. It is planned as a
/// cutter whose radius is smaller by the rounding and which keeps that much more distance from upright walls; leaning ones it
/// touches over its tip, and comes nearer. Ball ends have no flat part and are planned as flat ones as wide as their distance
/// from walls. `stock_above`: how far earlier work has left material
/// above the top of the feature, mm; the first layer begins there.
std::vector<Layer> layers_of(const Feature& feature, const Operation& operation, double tool_radius,
                             const Tolerances& tol, const RoundedEnd& end = {}, double stock_above = 0);

/// Whether both hold the same regions, edge by edge.
bool same_outline(const Regions& a, const Regions& b);

/// A strategy that plans each outline once: a layer that differs from the one before in height alone gets the
/// same passes at its own depth.
Strategy once_per_outline(Strategy plan);

}  // namespace clearcut::plan
