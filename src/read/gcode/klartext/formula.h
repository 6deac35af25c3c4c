// Formulas of Q parameters in Klartext: "Q1 * SIN Q2 + ( 4 - Q3 ) ^ 2".
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace clearcut::read::gcode {

/// `text`: behind the equals sign, upper case, without blanks. `value_of`: of Q parameters by number. Angles in degrees. Powers come before
/// products, these before sums; a function takes what stands directly behind it.
///
/// Throws  InputError(place, ...) for what is no formula, for functions that are not read, and for values that no control holds.
double formula_value(std::string_view text, const std::function<double(int)>& value_of,
                     const std::string& place);

}  // namespace clearcut::read::gcode
