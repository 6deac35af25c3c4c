// What becomes of the features of a solid: their tops, removal of those not worth a cut, and the user's rules, `--op
// KIND:SELECTION` and the rules of jobs.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/tolerances.h"
#include "model/part.h"
#include "options/read_options.h"

namespace clearcut::read {

/// Sets top_z of every feature to the height left by earlier ones, and removes features then no deeper than a
/// permitted gouge: the checks ignore walls of this height, and no cutter follows them. Returns the removed features,
/// in the same order.
std::vector<Feature> settle_tops(std::vector<Feature>& features, const Stock& stock, const Tolerances& tol);

/// Gives each feature its name in `info` and in the plan: names already in use get a number.
void name_features(std::vector<Feature>& features);

/// Applies the rules to the features of a solid, which must have their names: kinds of holes make round holes tapped,
/// reamed, countersunk and so on; `pocket` has a round hole milled; `inside` and `profile` cut a hole or the outside
/// out along its wall; `chamfer` breaks the edge at a feature's top; `ignore` leaves one out.
///
/// Depths are those of the solid; a kind with a depth (tap_m6_d12) states the full depth of a thread, a chamfer or a
/// hole.
/// Throws  InputError at "--op" for a selection without a matching feature, and for kinds impossible for the feature.
void apply_operations(std::vector<Feature>& features, const Stock& stock, const ReadOptions& options,
                      Diagnostics& diagnostics);

}  // namespace clearcut::read
