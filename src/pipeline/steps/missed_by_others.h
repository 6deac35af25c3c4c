// Parts of a layer that other features were to remove, but could not.
#pragma once

#include "model/layer.h"
#include "model/options/resolved_plan.h"

namespace clearcut::pipeline {

/// For a layer that, by the outlines of earlier work, is already clear: the part not reached by the cutters of that
/// work, as in narrow corners, but within reach of this workingstep's cutter. Nothing for walls with draft. Slivers
/// are left out. The layer must belong to a feature closed all round. Cost: some offsets and booleans for each
/// earlier workingstep overlapping the layer.
Regions missed_by_others(int workingstep, const Layer& layer, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
