// Several set-ups of one workpiece as one STEP-NC program with their toolpaths.
#pragma once

#include "clearcut/plan.h"
#include "post/part/stepnc_setups.h"

namespace clearcut {

using post::write_stepnc;
using post::WrittenSetup;

}  // namespace clearcut
