// Arithmetic in aperture macros: "$1x0.5+($2-1)/2".
#pragma once

#include <map>
#include <optional>
#include <string_view>

namespace clearcut::read {

/// Values of $1, $2, ...; those that are not set are 0.
using MacroVariables = std::map<int, double>;

/// + - x / and parentheses. Nothing for what is no expression, and for results that are no finite numbers. Cost O(text).
std::optional<double> macro_value(std::string_view text, const MacroVariables& variables);

}  // namespace clearcut::read
