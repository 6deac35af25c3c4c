// Canned drilling cycles, made into moves.
#pragma once

#include <optional>

#include "read/gcode/builder.h"

namespace clearcut::read::gcode {

/// The sticky words of a run of cycle blocks. Heights absolute, mm.
struct DrillCycle {
  int code = 0;                ///< G word in tenths: 810 is G81
  std::optional<double> z;     ///< bottom
  std::optional<double> r;     ///< retract plane
  std::optional<double> peck;  ///< Q word, mm
};

/// True for the cycles drill() knows: G73, G74, G81 to G86, G89.
bool is_drill_cycle(int code);

/// One hole at the current place: rapid to the retract plane, down to the bottom as the cycle says, back up
/// to `clear_z`. Throws InputError for missing or impossible words.
void drill(ToolpathBuilder& builder, const DrillCycle& cycle, double clear_z, MmPerMin feed, int line);

}  // namespace clearcut::read::gcode
