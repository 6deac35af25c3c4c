// The words of Okuma's OSP that other word-address controls have not, or have for something else. Sources are in docs/programs.md.
#pragma once

#include "read/gcode/control/control.h"

namespace clearcut::read::gcode {

/// The block in words that all controls here share: G15 H, G53, G56 H, G16 H0, G71 Z, G4 F and M53 are carried out or said otherwise.
/// Throws InputError for words of OSP that are not read, and for words that say something else there.
Block without_osp_words(const Block& block, Control& control);

}  // namespace clearcut::read::gcode
