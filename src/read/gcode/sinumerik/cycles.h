// Sinumerik's cycles for holes, made into moves.
#pragma once

#include "read/gcode/control/control.h"
#include "read/gcode/sinumerik/words.h"

namespace clearcut::read::gcode {

/// CYCLE81 to CYCLE85, CYCLE89 and CYCLE840.
bool is_sinumerik_hole(const std::string& name);

/// Refuses a call that cannot be understood, when it is met and not first at a hole.
void check_sinumerik_hole(Control& control, const SinumerikWord& call);

/// The hole where the tool stands: down to where feeding begins, to the bottom as the cycle says, and up to the return plane.
void make_sinumerik_hole(Control& control, const SinumerikWord& call);

}  // namespace clearcut::read::gcode
