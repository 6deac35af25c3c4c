// What the user says about features of a solid: `--op KIND:SELECTION` and the rules of jobs.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/tolerances.h"
#include "model/part.h"
#include "read/common/read_options.h"

namespace clearcut::read {

/// Gives each feature the name that it has in `info` and in the plan: names that are taken get a number.
void name_features(std::vector<Feature>& features);

/// Applies the rules to the features of a solid, which have their names: kinds of holes make round holes tapped, reamed, countersunk and so
/// on; `pocket` has a round hole milled; `inside` and `profile` cut a hole or the outside out along its wall; `chamfer` breaks the edge at
/// a feature's top; `ignore` leaves one out.
///
/// Depths are those of the solid; a kind with a depth (tap_m6_d12) states how far down a thread, a chamfer or a hole is full.
/// Throws  InputError at "--op" for a selection that names no feature, and for kinds that the feature cannot be.
void apply_operations(std::vector<Feature>& features, const Stock& stock, const ReadOptions& options,
                      Diagnostics& diagnostics);

}  // namespace clearcut::read
