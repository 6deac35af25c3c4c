#include "read/gcode/control/canned_cycles.h"

#include <algorithm>
#include <cmath>

#include "base/inch.h"
#include "read/gcode/words/g_words.h"

namespace clearcut::read::gcode {

namespace {

constexpr double kMostRepeats = 10000;

}  // namespace

/// The words stay in force for the following blocks of the cycle; on some controls for other cycles, too.
void CannedCycles::set_cycle_words(const Block& block) {
  const std::size_t across = axes_of(control_.modes.plane).across;
  check_dwell(block);
  if (control_.cycle.code == 0) {
    control_.cycle = {};
    control_.cycle.level = control_.builder.known(across, control_.line) - control_.frame.shift(across);
  } else if (control_.cycle.code != control_.motion) {
    control_.depends_on_dialect = true;
    if (!control_.rules.keeps_cycle_words)
      control_.cycle.z = control_.cycle.r = control_.cycle.peck = std::nullopt;
  }
  control_.cycle.code = control_.motion;
  const char bottom = "XYZ"[across];
  if (block.has(bottom)) control_.cycle.z = control_.mm(block.value(bottom));
  if (block.has('R')) control_.cycle.r = control_.mm(block.value('R'));
  if (block.has('Q')) control_.cycle.peck = control_.mm(block.value('Q'));
  if (block.has('P')) control_.cycle.dwell = block.value('P') * (control_.rules.dwell_in_ms ? 0.001 : 1);
  if (!control_.cycle.z || !control_.cycle.r)
    control_.refuse("drilling cycle without its Z or R word; give both");
}

/// LinuxCNC asks for the time of a dwell wherever a cycle begins that dwells.
void CannedCycles::check_dwell(const Block& block) const {
  const int code = control_.motion;
  const bool dwells = code == 820 || code == 860 || code == 880 || code == 890;
  if (dwells && control_.rules.cycle_needs_dwell && control_.cycle.code != code && !block.has('P'))
    control_.refuse(g_word(code) + " without its P word, which " + std::string(control_.rules.title) +
                    " asks for; add the seconds of the dwell");
}

/// In G91, R counts from a height before the cycle and Z from R.
void CannedCycles::set_cycle_heights(Hole& hole) {
  const double shift = control_.frame.shift(hole.across);
  const double level = control_.cycle.level + shift;
  hole.r = *control_.cycle.r + (control_.modes.absolute ? shift : level);
  hole.bottom = *control_.cycle.z + (control_.modes.absolute ? shift : hole.r);
  hole.clear = control_.modes.return_to_level ? std::max(level, hole.r) : hole.r;
  if (!control_.modes.absolute) control_.depends_on_dialect = true;
  if (hole.r < hole.bottom) control_.refuse("drilling cycle whose R lies below its Z; correct it");
  if (control_.return_said || std::max(level, hole.r) == hole.r) return;
  control_.depends_on_dialect = true;
  control_.condition(control_.modes.return_to_level ? "g98" : "g99",
                     std::string("the program states neither G98 nor G99; the control is in ") +
                         (control_.modes.return_to_level ? "G98 and returns to the height before the cycle"
                                                         : "G99 and returns to R"));
}

double CannedCycles::repeats(const Block& block) const {
  const double count = block.has('L') ? block.value('L') : block.has('K') ? block.value('K') : 1;
  if (!(count >= 0 && count <= kMostRepeats))
    control_.refuse("L word with an impossible number of repeats; correct it");
  return count;
}

/// '@' and '^' in G91 count from where each hole was.
Block CannedCycles::counted_on(Block block) {
  block.unset('X');
  block.unset('Y');
  return control_.without_polar_words(block);
}

void CannedCycles::execute(const Block& block) {
  set_cycle_words(block);
  const PlaneAxes axes = axes_of(control_.modes.plane);
  if (control_.modes.plane != Plane::kXY) {
    control_.depends_on_dialect = true;
    if (control_.motion == 840 || control_.motion == 740)
      control_.refuse(g_word(control_.motion) +
                      " outside the XY plane mixes the axes up on LinuxCNC; use G17");
  }
  for (const std::size_t axis : {0U, 1U, 2U}) control_.builder.known(axis, control_.line);
  Hole hole;
  hole.code = control_.motion;
  hole.across = axes.across;
  hole.peck = control_.cycle.peck.value_or(0);
  hole.gap = control_.modes.unit == 1 ? 0.254 : 0.01 * kMmPerInch;
  hole.dwell = control_.cycle.dwell;
  hole.feeds_out_to_clear = control_.rules.feeds_out_to_clear;
  hole.tap = {control_.motion == 740,
              control_.rules.taps == TapRule::kTied ||
                  (control_.rules.taps == TapRule::kTiedByM29 && control_.tied_by_m29),
              control_.rules.taps != TapRule::kAsItTurns};
  set_cycle_heights(hole);
  if (hole.feeds_out_to_clear != (hole.clear == hole.r) &&
      (control_.motion == 740 || control_.motion == 840 || control_.motion == 890)) {
    control_.depends_on_dialect = true;
  }
  for (int n = static_cast<int>(repeats(block)); n > 0; --n) {
    go_over_hole(block.is_polar() ? counted_on(block) : block, hole);
    drill(control_.builder, hole, control_.feed_for(1, block), control_.line);
  }
}

/// LinuxCNC goes up only where the cycles began below R, and takes the rest of the way up with the way over.
void CannedCycles::go_over_hole(const Block& block, const Hole& hole) {
  const PlaneAxes axes = axes_of(control_.modes.plane);
  Target over, down;
  down[axes.across] = hole.r;
  const double at = *control_.builder.position()[axes.across];
  if (control_.rules.cycle_rises_over ? control_.cycle.level + control_.frame.shift(axes.across) < hole.r
                                      : at < hole.r)
    control_.builder.rapid(down, control_.line);
  const Target said = control_.target(block);
  for (const std::size_t axis : {axes.first, axes.second}) over[axis] = said[axis];
  const double now = *control_.builder.position()[axes.across];
  if (control_.rules.cycle_rises_over && now <= hole.r) over[axes.across] = hole.clear;
  control_.builder.rapid(over, control_.line);
  control_.builder.rapid(down, control_.line);
}

}  // namespace clearcut::read::gcode
