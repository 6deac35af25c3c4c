#include "read/gcode/motion/cycle.h"

#include "base/error.h"
#include "base/text.h"

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

void note_oriented_retract(ToolpathBuilder& builder, int line, const std::string& aside) {
  builder.condition("oriented-retract", line,
                    "the boring bar stops turned and goes aside, " + aside +
                        ", before it comes out: away from the wall that it has cut, with room behind it");
}

namespace {

constexpr double kMostPecks = 10000;

Target place_along(const Hole& hole, double value) {
  Target target;
  target[hole.across] = value;
  return target;
}

void peck_down(ToolpathBuilder& builder, const Hole& hole, MmPerMin feed, int line) {
  if (!(hole.peck > 0) || (hole.r - hole.bottom) / hole.peck > kMostPecks) {
    throw InputError(builder.place(line), "peck drilling needs a Q word of a sensible size; correct it");
  }
  for (double depth = hole.r - hole.peck; depth > hole.bottom; depth -= hole.peck) {
    builder.feed(place_along(hole, depth), feed, line);
    if (hole.code == 830) builder.rapid(place_along(hole, hole.r), line);
    builder.rapid(place_along(hole, depth + hole.gap), line);
  }
  builder.feed(place_along(hole, hole.bottom), feed, line);
}

/// Whether the tap comes out all the way for its chips, as here, or goes back by a setting, it cuts the same.
void tap_down(ToolpathBuilder& builder, const Hole& hole, MmPerMin feed, int line) {
  const double each = hole.taps_peck ? hole.peck : 0;
  if (each < 0 || (each > 0 && (hole.r - hole.bottom) / each > kMostPecks))
    throw InputError(builder.place(line), "peck tapping needs a Q word of a sensible size; correct it");
  for (double depth = hole.r - each; each > 0 && depth > hole.bottom; depth -= each) {
    builder.feed(place_along(hole, depth), feed, line);
    builder.turn_tap_back(hole.tap, line);
    builder.feed(place_along(hole, hole.r), feed, line);
  }
  builder.feed(place_along(hole, hole.bottom), feed, line);
}

}  // namespace

void CycleWords::scale(double factor) {
  for (auto* word : {&z, &r, &peck}) {
    if (*word) **word *= factor;
  }
  level *= factor;
}

bool is_drill_cycle(int code) {
  return code == 730 || code == 740 || (code >= 810 && code <= 860 && code % 10 == 0) || code == 890;
}

void drill(ToolpathBuilder& builder, const Hole& hole, MmPerMin feed, int line) {
  const bool taps = hole.code == 740 || hole.code == 840;
  if (hole.code == 730 || hole.code == 830) {
    peck_down(builder, hole, feed, line);
  } else if (taps) {
    tap_down(builder, hole, feed, line);
  } else {
    builder.feed(place_along(hole, hole.bottom), feed, line);
  }
  if (hole.dwell > 0) add_dwell_in_hole(builder, line, hole.dwell);
  if (taps) builder.turn_tap_back(hole.tap, line);
  if (hole.hands_take_it_out) {
    builder.add_event(ControlEventKind::kPause, line);
    builder.condition(
        "manual-retract", line,
        "the control stops at the bottom of the hole, and the operator takes the tool straight up out of it");
  }
  const bool feeds_out = taps || hole.code == 890;
  if (feeds_out || hole.code == 850) {
    const bool all = feeds_out && hole.feeds_out_to_clear;
    builder.feed(place_along(hole, all ? hole.clear : hole.r), feed, line);
  }
  builder.rapid(place_along(hole, hole.clear), line);
}

}  // namespace clearcut::read::gcode
