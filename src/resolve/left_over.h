// What earlier steps of a feature, or an earlier program, leave of a layer.
#pragma once

#include <functional>

#include "model/layer.h"
#include "model/move.h"
#include "model/part.h"

namespace clearcut::resolve {

/// Where the centre line's outline was bounded when an earlier workingstep of the feature cut down to a layer, or nothing where it
/// was by what bounds the layer.
using RoomBefore = std::function<std::optional<Regions>(int workingstep)>;

/// The part of `layer.target` that the milling steps before `workingstep` on the same feature cannot have reached, less
/// what `earlier`, a program that has run before, has cut down to the layer. A little more than that at its borders, so that
/// what is planned for it overlaps; slivers below half of tol.uncut are left out. Of what an earlier program has left, only what
/// lies in reach of the step's cutter counts, farther than 0.007 mm from what is cut. With drafted walls, and where no earlier
/// step reaches the layer: all of the target. The part is prepared. `room`: pockets that run into the feature may have bounded
/// earlier steps otherwise, whose layers lie at other heights.
Regions left_over(const Part& part, int workingstep, const Layer& layer,
                  const std::optional<Toolpath>& earlier, const Tolerances& tol, const RoomBefore& room = {});

/// What a cutter of `radius` mm sweeps that keeps `stock` mm from the walls of `allowed`, and `more` mm round it (less than
/// 0: inside it).
Regions swept(const Regions& allowed, double radius, double stock, double more, const Tolerances& tol);

/// Whether `earlier` may have cut anything of a workingstep's feature: a program on the same set-up always may, cuts of other
/// set-ups where they come near.
bool meets_earlier(const Part& part, int workingstep, const std::optional<Toolpath>& earlier);

/// Whether an earlier step of the workplan mills the same feature.
bool follows_milling(const Part& part, int workingstep);

/// Whether anything of `left` is more than `thickness` mm wide.
bool is_thicker_than(const Regions& left, double thickness, const Tolerances& tol);

}  // namespace clearcut::resolve
