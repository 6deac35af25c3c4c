// Steps that their tools are too short for.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::resolve {

/// For each workingstep of `part`, as prepared, why it is left out although other steps are made: its feature lies deeper
/// than the flutes of its tools reach, or the end of its tool would come out below the material, in all of its steps; or another step of the same
/// hole is left out. "" for all other steps, for workingsteps of a STEP-NC program, profiles, chamfers and carvings,
/// and where other work rests on the feature: such a part is refused as a whole.
std::vector<std::string> unreached_steps(const Part& part, const Tolerances& tol);

/// Whether the tool's flutes reach the feature's floor from the top of the part, or, where their length is not stated,
/// the feature is no deeper than such tools usually go.
bool reaches_floor(const Part& part, const Feature& feature, const Tool& tool);

/// Takes those of the workingsteps named by `rests` out of the workplan of `part` whose tools are too short for a floor that
/// another step reaches, each an open condition "out-of-reach".
void drop_unreached_rests(Part& part, const std::set<std::string>& rests, const Tolerances& tol);

}  // namespace clearcut::resolve
