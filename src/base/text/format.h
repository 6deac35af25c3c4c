// Numbers and text for people and programs, without locale.
#pragma once

#include <string>
#include <vector>

namespace clearcut::inline base {

/// Fixed notation with `decimals` digits, trailing zeros and a trailing point removed, never "-0".
std::string trimmed(double value, int decimals);

/// The parts between separators: one more than there are separators, empty ones included.
std::vector<std::string> split(const std::string& text, char separator);

}  // namespace clearcut::inline base
