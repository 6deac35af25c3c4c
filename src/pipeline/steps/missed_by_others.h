// What other features were to take of a layer, and could not.
#pragma once

#include "model/layer.h"
#include "model/options/resolved_plan.h"

namespace clearcut::pipeline {

/// Of a layer over which nothing stands by the outlines of what was cut before: the part that none of the cutters of that
/// work reached, as in narrow corners, and that the cutter of this workingstep reaches. Nothing where walls have draft. Slivers are
/// left out. The layer is that of a feature closed all round. Cost: some offsets and booleans for each earlier workingstep that
/// meets the layer.
Regions missed_by_others(int workingstep, const Layer& layer, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
