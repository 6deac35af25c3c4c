// A picture in which the cutter moves: SVG that plays by itself, in a browser and in pages that show pictures.
#pragma once

#include <string>
#include <vector>

#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"

namespace clearcut::report {

/// Longest duration of an animation, s; longer machining is shown faster.
inline constexpr double kLongestAnimation = 120;

/// Shape   one SVG document without scripts: the part from above, the cutter at its true diameter moving along the whole program, and
///         what it has cut in the shade of its depth; clock, tool, verdict. It begins anew at its end.
/// Time    `move_times_s` holds the time of every move, section after section. Within a layer the cutter moves evenly.
/// Units   mm in the part's frame. Non-finite moves are left out.
/// Cost    O(moves); about 50 bytes for each move.
std::string animated_svg(const Part& part, const Toolpath& toolpath, const Findings& findings,
                         const std::vector<double>& move_times_s);

}  // namespace clearcut::report
