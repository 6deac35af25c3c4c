// The part of a layer left by earlier steps of a feature, or by an earlier program.
#pragma once

#include <functional>

#include "model/layer.h"
#include "model/move.h"
#include "model/part.h"

namespace clearcut::resolve {

/// The permitted area (`allowed`) of an earlier workingstep of the feature when it cut down to a layer; nothing if
/// this was the area of the layer itself.
using RoomBefore = std::function<std::optional<Regions>(int workingstep)>;

/// The part of `layer.target` not reachable by the milling steps before `workingstep` on the same feature, minus the
/// area cut down to the layer by `earlier`, a program run before. It is slightly enlarged at its borders, so that
/// passes planned for it overlap with cut areas; slivers below half of tol.uncut are left out. Of the material left
/// by an earlier program, only the part within reach of the step's cutter and farther than 0.007 mm from the cut area
/// counts. With drafted walls, and if no earlier step reaches the layer: the whole target. The part must be prepared.
/// `room`: pockets running into the feature may have bounded earlier steps differently, since their layers are at
/// other heights.
Regions left_over(const Part& part, int workingstep, const Layer& layer,
                  const std::optional<Toolpath>& earlier, const Tolerances& tol, const RoomBefore& room = {});

/// The area swept by a cutter of `radius` mm at a distance of `stock` mm from the walls of `allowed`, enlarged by
/// `more` mm (negative: reduced).
Regions swept(const Regions& allowed, double radius, double stock, double more, const Tolerances& tol);

/// Whether `earlier` may have cut a part of a workingstep's feature: always possible for a program on the same
/// set-up; for cuts of other set-ups if they are near.
bool meets_earlier(const Part& part, int workingstep, const std::optional<Toolpath>& earlier);

/// Whether an earlier step of the workplan mills the same feature.
bool follows_milling(const Part& part, int workingstep);

/// Whether anything of `left` is more than `thickness` mm wide.
bool is_thicker_than(const Regions& left, double thickness, const Tolerances& tol);

}  // namespace clearcut::resolve
