// G12 and G13 of Haas: a circle milled from its centre.
#pragma once

#include "read/gcode/control/control.h"

namespace clearcut::read::gcode {

/// Whether the block has one of them, whose moves are made then: along half a circle out to the radius I less that of the tool (D), once
/// round, and along half a circle back to the centre. Throws InputError for what is not read of them, and on other controls.
bool mill_circle(Control& control, const Block& block);

}  // namespace clearcut::read::gcode
