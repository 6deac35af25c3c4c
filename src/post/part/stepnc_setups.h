// Writes the set-ups of one workpiece as one STEP-NC program.
#pragma once

#include <string>
#include <vector>

#include "model/results/machined_setup.h"
#include "model/setup_place.h"
#include "post/part/part_writers.h"

namespace clearcut::post {

/// The same as write_stepnc() of a part with its toolpath, for several set-ups: a WORKPLAN and a SETUP for each, features in the
/// coordinates of the workpiece.
///
/// Throws  besides: InputError where a set-up is not turned by right angles, or its zero is not that of the workpiece.
std::string write_stepnc(const std::vector<WrittenSetup>& setups);

}  // namespace clearcut::post
