// Canned drilling cycles, made into moves, and waits; those that nobody means become the condition `dwell`.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "read/gcode/motion/builder.h"

namespace clearcut::read::gcode {

/// A wait between moves, of which so many are written: seconds, or milliseconds.
void add_dwell(ToolpathBuilder& builder, int line, double written, bool in_ms);

/// A wait at the bottom of a hole.
void add_dwell_in_hole(ToolpathBuilder& builder, int line, double seconds);

/// A boring bar stops turned at the bottom and goes aside before it comes out; `aside`: how far and where, in words.
void note_oriented_retract(ToolpathBuilder& builder, int line, const std::string& aside);

/// Why G77, G87 and cycle 204 are refused, behind their name.
inline constexpr std::string_view kBoresFromBelow =
    " bores from below, where its bar comes past the hole's wall aside and turned, which is not read; check "
    "that hole apart";

/// The words that hold during a run of cycle blocks, mm, as they were written.
struct CycleWords {
  int code = 0;                ///< G word in tenths: 810 is G81; 0 while there is no cycle
  std::optional<double> z;     ///< bottom: the word of the axis across the plane
  std::optional<double> r;     ///< retract plane
  std::optional<double> peck;  ///< Q word
  double dwell = 0;            ///< s
  double level = 0;            ///< where the tool was before the first block, as the program counts

  void scale(double factor);
};

/// One hole along the axis `across`; places absolute, mm.
struct Hole {
  int code = 0;
  std::size_t across = 2;
  double bottom = 0;
  double r = 0;
  double clear = 0;  ///< where the cycle ends
  double peck = 0;
  double gap = 0.254;  ///< above the last depth, where feeding begins again
  double dwell = 0;    ///< s, at the bottom
  bool feeds_out_to_clear = false;
  TapCycle tap = {};               ///< of G74 and G84
  bool taps_peck = false;          ///< of those, by `peck`
  bool hands_take_it_out = false;  ///< at the bottom the control waits for the operator
};

/// True for the cycles that all controls with cycles have: G73, G74, G81 to G86, G89. drill() makes the holes of G76, G87 and G88, too.
bool is_drill_cycle(int code);

/// From the retract plane down to the bottom as the cycle says, and back to hole.clear. Throws InputError for pecks of
/// an impossible size.
void drill(ToolpathBuilder& builder, const Hole& hole, MmPerMin feed, int line);

}  // namespace clearcut::read::gcode
