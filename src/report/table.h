// The final table of the command: one line per feature, the total, and the faults.
#pragma once

#include <cstddef>
#include <string>

#include "model/part.h"
#include "model/results/findings.h"

namespace clearcut::report {

/// Shape   heading, one row per feature and tool in the order of work, the total, then the faults: the worst
///         ten with their places, and the number of the others.
/// Units   mm, mm2, degrees, hours:minutes:seconds, each named in its heading. Uncut mm is the proven bound.
/// Text    ASCII, no line of the table wider than `width` columns; a figure that is not a number is "?".
std::string table(const Part& part, const Findings& findings, std::size_t width = 120);

}  // namespace clearcut::report
