// Names of units of length.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace clearcut::read {

/// mm per unit for "mm", "cm", "m", "um", "in" (also "inch", "inches"), "ft", "mil"/"thou", "pt", "pc",
/// "px" (96 per inch); upper or lower case. Exact: an inch is 25.4 mm.
std::optional<double> mm_per_unit(std::string_view name);
/// The names accepted by mm_per_unit, for messages.
const std::string& known_units();
/// mm per unit of `name`; throws InputError at `place` when the unit is unknown.
double require_unit(std::string_view name, const std::string& place);

}  // namespace clearcut::read
