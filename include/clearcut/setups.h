// Several set-ups of one workpiece as one STEP-NC program with their toolpaths.
#pragma once

#include <string>
#include <vector>

#include "clearcut/part.h"
#include "model/results/machined_setup.h"

namespace clearcut {

/// As write_stepnc() of a part with its toolpath, for several set-ups: a WORKPLAN and a SETUP for each, features in the
/// coordinates of the workpiece. Throws InputError where a set-up is not turned by right angles.
std::string write_stepnc(const std::vector<WrittenSetup>& setups);

}  // namespace clearcut
