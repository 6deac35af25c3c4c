// The lines that bring a control from its start into the state that it had before a line of a program, and the place
// where a cutter comes down beside a wall that it goes on cutting along.
#pragma once

#include <optional>
#include <string>

#include "model/part.h"
#include "pipeline/check.h"
#include "read/gcode/control/held_state.h"

namespace clearcut::pipeline {

/// Heights and feeds of the way in. mm, mm/min.
struct WayIn {
  double safe_z = 0;                ///< nothing stands above it; at it the cutter goes over the place
  double entry_z = 0;               ///< down to here by a rapid, below it at `plunge`
  double plunge = 0;                ///< 0: the program has fed nowhere with this tool
  std::optional<Vec2> beside = {};  ///< down here, and from here straight to the place
  bool is_needed = true;            ///< false: the tool is changed before anything moves
  bool semicolons = false;          ///< comments of the program begin with ';'
  bool tools_by_comments = false;   ///< the control has no words for tools
};

/// Heights of the way down to where the program goes on, mm; absent: no such move.
struct WayDown {
  std::optional<double> rapid_to;  ///< above what stands
  std::optional<double> feed_to;   ///< at the plunge feed
};
/// From the safe height to the height of the held place. `held` has a place.
WayDown way_down(const read::gcode::HeldState& held, const WayIn& way);

/// Lines, each with its end, in the control's language. Throws nothing: what they do is read back by the caller.
std::string lines_that_begin_again(const read::gcode::HeldState& held, const read::gcode::DialectRules& rules,
                                   const WayIn& way, int line);

/// As lines_that_begin_again(), of Klartext, without block numbers.
std::string klartext_that_begins_again(const read::gcode::HeldState& held, const WayIn& way, int line);

/// A place at the height `z` beside `place`, where a flat end mill touches nothing and from which it comes straight to `place` through what
/// `first` has cut; nothing where it touches nothing at `place` either, where there is no such place, and for other tools. mm.
std::optional<Vec2> lead_place(const Part& part, const FirstPart& first, const Tool& tool, Vec2 place,
                               double z);

}  // namespace clearcut::pipeline
