// One page that plays the machining, needs no network and no other file.
#pragma once

#include <string>
#include <vector>

#include "model/machine.h"
#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"

namespace clearcut::report {

struct HtmlOptions {
  Machine machine;      ///< for the time of each move, where `move_times_s` is empty
  std::string program;  ///< text of the program that was checked; shown line by line when Move::line is known
  const Toolpath* earlier =
      nullptr;  ///< what was cut before: nothing of it is left when the page begins to play
  /// Of every move, section after section, with the waits before it: as the certificate counts them, so that the
  /// clock of the page ends at its machining time.
  std::vector<double> move_times_s = {};
  std::string material = {};  ///< of the work, a name of work_materials(); "": not known
};

/// Shape   a well-formed HTML page (also XML) that takes material away move by move, shaded by depth, true to
///         time; play, speed, scrub, zoom; verdict, features, figures, feed and engagement over time; a click
///         on a move finds its line and back, a click on a fault goes to its moment and place. "#t=SECONDS", "#line=NUMBER" or "#fault=INDEX" behind the address opens it there.
/// Units   moves to 1 um, times to 0.1 ms (kinematic model of move_times).
/// Size    about 30 bytes a move.
/// Text    every name is data, never markup; moves that are not finite are left out.
std::string html(const Part& part, const Toolpath& toolpath, const Findings& findings,
                 const HtmlOptions& options = {});

}  // namespace clearcut::report
