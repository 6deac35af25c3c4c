// The stepover of strategies cutting along lines or spirals instead of offset contours.
#pragma once

#include <optional>

#include "model/options/stepover.h"

namespace clearcut::plan {

/// mm between neighbouring lines for a cutter of `diameter` mm; nothing if the rule leaves it to the
/// strategy. Throws InputError for rules about angles between contours, which do not apply to lines.
std::optional<double> line_distance(const Stepover& stepover, double diameter);

}  // namespace clearcut::plan
