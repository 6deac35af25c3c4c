// Cuts a feature into the layers planned by the strategies.
#pragma once

#include <vector>

#include "model/layer.h"
#include "model/part.h"

namespace clearcut::plan {

/// The heights of the tip, mm, from the top down: from `top_z` to exactly `floor_z` in steps of at most
/// `stepdown`.
///
/// Every layer is `stepdown` deep and the last takes the rest. If that rest is less than 5 % of the step, all
/// layers are made equally deep instead, one layer fewer than before. Empty for floor_z >= top_z. Throws InputError
/// for a stepdown that is not positive or requires more than 10 000 layers.
std::vector<double> layer_heights(double top_z, double floor_z, double stepdown);

/// The end of a cutter beside its flat part.
struct RoundedEnd {
  double round = 0;  ///< mm; radius of the rounding; the cutter's radius for balls
  /// The rounded end touches inclined walls, over its tip; else the cutter keeps the distance of a flat end.
  bool touches_walls = false;
};

/// The layers of `feature` cut by `operation` with a tool of `tool_radius` mm, from the top down.
///
/// The lowest layer is at floor_z + allowance_floor. Without a stepdown, it is tool_radius (half the
/// diameter). Under walls with draft each layer has the outline at its own depth, so that no layer cuts into
/// the wall, and the stepdown is lowered until the steps on the wall are at most `operation.scallop` mm high, square
/// to the wall: scallop = stepdown * sin(draft) for flat ends. Layers below the depth at which their outline vanishes
/// (with draft the area becomes smaller with depth, until the walls of opposite sides meet) are left out.
///
/// A cutter with rounded corners cuts the floor only with the flat part of its end. It is planned as a cutter with a
/// radius smaller by the rounding, with correspondingly more distance from vertical walls; it touches inclined walls
/// over its tip, and comes nearer to them. Ball ends have no flat part and are planned as flat ones as wide as their
/// distance from walls, but no wider than the ball is at the top of the feature. `stock_above`: height of the material
/// left by earlier work above the top of the feature, mm; the first layer begins at the top of this material.
std::vector<Layer> layers_of(const Feature& feature, const Operation& operation, double tool_radius,
                             const Tolerances& tol, const RoundedEnd& end = {}, double stock_above = 0,
                             const std::vector<double>& others = {});

/// The heights of these layers, of which the topmost begins at `top`. `others`: heights at which other steps come to the same leaning
/// walls, from the top down. What one cutter leaves on a wall at a height the other has to cut at the same height, or the wall of
/// neither is ever cleared as a whole: they are kept as far as the stepdown allows.
std::vector<double> heights_of(const Feature& feature, const Operation& operation, double tool_radius,
                               const RoundedEnd& end, double top, const std::vector<double>& others = {});

/// Whether both hold the same regions, edge by edge.
bool same_outline(const Regions& a, const Regions& b);

/// A strategy that plans each outline once: a layer that differs from the previous one only in height gets the same
/// passes at its own depth.
Strategy once_per_outline(Strategy plan);

}  // namespace clearcut::plan
