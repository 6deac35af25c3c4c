// G12 and G13 of Haas: round pockets that the control mills about the place where the tool stands.
#pragma once

#include "read/gcode/control/control.h"
#include "read/gcode/words/block.h"

namespace clearcut::read::gcode {

/// Whether the block has one of the two words, whose moves are made then. Throws InputError for what is not read of them, and on other
/// controls.
bool mill_circle(Control& control, const Block& block);

}  // namespace clearcut::read::gcode
