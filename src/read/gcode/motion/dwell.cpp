#include "read/gcode/motion/dwell.h"

#include "base/text/format.h"

namespace clearcut::read::gcode {

namespace {

/// s. Nobody waits longer on purpose: between moves a spindle has started, in a hole its bottom is smooth.
constexpr double kLongestDwell = 60, kLongestDwellInHole = 10;
/// ms. Where a time is written in milliseconds, what is less was meant as seconds.
constexpr double kShortestMs = 20;

void note_long_dwell(ToolpathBuilder& builder, int line, double seconds) {
  builder.condition("dwell", line,
                    "the program waits for " + trimmed(seconds, 1) +
                        " s, as the control reads the time of a dwell; so long a wait is meant, and no "
                        "milliseconds are");
}

}  // namespace

void add_dwell(ToolpathBuilder& builder, int line, double written, bool in_ms) {
  const double seconds = in_ms ? written / 1000 : written;
  builder.add_event(ControlEventKind::kDwell, line, seconds);
  if (seconds > kLongestDwell) note_long_dwell(builder, line, seconds);
  if (in_ms && written > 0 && written < kShortestMs)
    builder.condition("dwell", line,
                      "the control reads the time of a dwell in milliseconds: " + trimmed(written, 3) +
                          " ms are enough, and no seconds are meant");
}

void add_dwell_in_hole(ToolpathBuilder& builder, int line, double seconds) {
  builder.add_event(ControlEventKind::kDwell, line, seconds);
  if (seconds > kLongestDwellInHole) note_long_dwell(builder, line, seconds);
}

}  // namespace clearcut::read::gcode
