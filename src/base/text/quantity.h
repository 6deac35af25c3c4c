// Quantities as people write them: a number with a unit, or without.
#pragma once

#include <optional>
#include <string_view>

namespace clearcut::inline base {

/// A plain finite number, the whole text.
std::optional<double> plain_number(std::string_view text);

/// mm. "6", "6mm", "0.25in", "1/4in", "0.6cm"; nothing for other text.
std::optional<double> length_in_mm(std::string_view text);

/// mm/min. "800", "800mm/min", "40in/min", "40ipm", "15mm/s", "1.2m/min"; nothing for other text.
std::optional<double> feed_in_mm_per_min(std::string_view text);

}  // namespace clearcut::inline base
