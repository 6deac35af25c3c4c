// Steps that their tools are too short for.
#pragma once

#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::resolve {

/// For each workingstep of `part`, as prepared, why it is left out although other steps are made: its feature lies deeper
/// than the flutes of its tools reach, in all of its steps. "" for all other steps, for workingsteps of a STEP-NC program, profiles and features
/// with a form of their own, and where other work rests on the feature: such a part is refused as a whole.
std::vector<std::string> unreached_steps(const Part& part, const Tolerances& tol);

}  // namespace clearcut::resolve
