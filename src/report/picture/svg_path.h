// A closed curve as the data of an SVG path.
#pragma once

#include <string>

#include "geometry/region.h"

namespace clearcut::report {

/// "M0 0L40 0A5 5 0 0 1 45 5Z": mm in the frame of the curve (y up), lines and true arcs of less than half a turn
/// each.
std::string svg_path(const Loop& loop);

}  // namespace clearcut::report
