// Words at which LinuxCNC and Grbl stop, since no other word of their block uses them.
#pragma once

#include "read/gcode/control/control.h"

namespace clearcut::read::gcode {

/// Called before the block is executed. What such a control stops at becomes the condition `stray-word`: a word lost its G word, or
/// a G word its axes.
void note_stray_words(Control& control, const Block& block);

}  // namespace clearcut::read::gcode
