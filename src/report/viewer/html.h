// One page animating the machining, without network access or other files.
#pragma once

#include <string>
#include <vector>

#include "model/machine.h"
#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"

namespace clearcut::report {

struct HtmlOptions {
  Machine machine;      ///< for the time of each move if `move_times_s` is empty
  std::string program;  ///< text of the checked program; shown line by line when Move::line is known
  const Toolpath* earlier = nullptr;  ///< earlier cuts: already removed at the start of the animation
  /// Time of every move, section after section, with the waits before the move: as counted in the certificate, so
  /// that the clock of the page ends at the certificate's machining time.
  std::vector<double> move_times_s = {};
  std::string material = {};  ///< of the work, a name of work_materials(); "": not known
};

/// Shape   a well-formed HTML page (also XML) that removes material move by move, shaded by depth, true to time;
///         play, speed, scrub, zoom; verdict, features, figures, feed and engagement over time; a click on a move
///         shows its line and vice versa, a click on a fault jumps to its moment and place. "#t=SECONDS",
///         "#line=NUMBER" or "#fault=INDEX" after the address opens the page there.
/// Units   moves to 1 um, times to 0.1 ms (kinematic model of move_times).
/// Size    about 30 bytes a move.
/// Text    every name is data, never markup; non-finite moves are left out.
std::string html(const Part& part, const Toolpath& toolpath, const Findings& findings,
                 const HtmlOptions& options = {});

}  // namespace clearcut::report
