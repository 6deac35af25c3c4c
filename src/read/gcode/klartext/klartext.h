// Heidenhain conversational programs, and Heidenhain's cycles 200 (drilling), 201 (reaming), 202 (boring), 203 (universal drilling), 205 (deep
// holes), 206 (tapping in a floating holder), 207 and 209 (rigid tapping, with broken chips) and 208 (bore milling), made into moves.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "read/gcode/control/held_state.h"
#include "read/gcode/motion/builder.h"
#include "read/gcode/motion/compensation.h"
#include "read/gcode/program/program.h"

namespace clearcut::read::gcode {

struct HoleCycle {
  int number = 0;
  std::map<int, double> parameters;  ///< Q200 to Q403, as they are written; infinite for MAX
  double tool_radius = 0;            ///< mm, where needs_radius()
};

bool is_hole_cycle(int number);

/// Whether the cycle runs beside its wall by the tool's radius.
bool needs_radius(const HoleCycle& cycle);

/// 3 or 4 as in M3, M4 for rigid tapping, which turns the spindle by itself and leaves it stopped; else 0.
int turning_of(const HoleCycle& cycle);

/// Makes the hole where the tool stands: at the rapid to the set-up clearance, down, and up again. `unit`: mm in the program's unit.
/// Throws InputError where a parameter is missing, is none of this cycle's, or asks for what no control does.
void make_hole(const HoleCycle& cycle, double unit, ToolpathBuilder& builder, int line);

/// Returns whether END PGM or M30 was seen. Throws InputError for blocks that would move the tool in ways
/// that are not understood.
bool read_klartext(std::string_view text, const CompensationValues& compensation, ToolpathBuilder& builder);

/// As scan_stops(), of a Klartext program. Blocks with radius compensation, between the moves of a corner, behind a shift of the datum and
/// within definitions cannot be begun anew; the scan ends where the program begins to compute or call.
StopScan scan_klartext_stops(std::string_view text, const std::string& file_name,
                             const ReadControllerOptions& options, int line);

}  // namespace clearcut::read::gcode
