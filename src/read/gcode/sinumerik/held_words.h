// What the words of a Sinumerik program leave behind until another of their kind comes.
#pragma once

#include "read/gcode/control/held_state.h"
#include "read/gcode/sinumerik/words.h"

namespace clearcut::read::gcode {

/// Keeps those of the block's words that a program begun anew has to repeat. The control's way of rounding corners is not among them: several
/// words make it together.
void keep_sinumerik_words(const SinumerikBlock& block, HeldWords& words);

}  // namespace clearcut::read::gcode
