// Heidenhain's cycles for one hole.
#pragma once

#include <string>

#include "post/words/drill_cycle.h"

namespace clearcut::post {

/// The definition of the cycle for exactly the moves of this hole: a block of several lines; CYCL CALL runs it at the
/// tool's position. "" if there is no such cycle, or if the meaning of its words is not certain: the moves are
/// written then. `surface`: Z of the material's top there, mm, between the bottom and the height at which feeding
/// begins.
std::string hole_cycle(const DrillBlock& hole, double surface, const Tool* tap, const PrintGrid& grid,
                       bool inch);

/// Whether the control can tie this tap's feed to its spindle: its pitch can be printed.
bool taps_rigidly(const Tool& tap, bool inch);

}  // namespace clearcut::post
