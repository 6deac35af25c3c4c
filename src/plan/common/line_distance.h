// The stepover of strategies that run lines instead of contours.
#pragma once

#include <optional>

#include "model/stepover.h"

namespace clearcut::plan {

/// mm between lines for a cutter of `diameter` mm; nothing where the strategy decides. Throws InputError for rules about
/// the angles of contours, which mean nothing to lines.
std::optional<double> line_distance(const Stepover& stepover, double diameter);

}  // namespace clearcut::plan
