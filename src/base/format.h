// Numbers and text for people and programs, without locale.
#pragma once

#include <string>

namespace clearcut {

/// Fixed notation with `decimals` digits, trailing zeros and a trailing point removed, never "-0".
std::string trimmed(double value, int decimals);

}  // namespace clearcut
