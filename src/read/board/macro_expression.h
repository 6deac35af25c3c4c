// Arithmetic in aperture macros: "$1x0.5+($2-1)/2".
#pragma once

#include <map>
#include <optional>
#include <string_view>

namespace clearcut::read {

/// Values of $1, $2, ...; unset ones are 0.
using MacroVariables = std::map<int, double>;

/// + - x / and parentheses. Nothing for other text, and for non-finite results. Cost O(text).
std::optional<double> macro_value(std::string_view text, const MacroVariables& variables);

}  // namespace clearcut::read
