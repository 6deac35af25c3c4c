// One page animating the machining, without network access or other files, and the job as input of the page's script:
// compact JSON. The script's side is in viewer/moves.js.
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

/// JSON in ASCII without '<', '>' and '&', so that it can be embedded in a page unchanged.
///
/// Fields  name, clean, verdict, asked (whether a part states the shape to be made), bad (colour of uncut material),
///         top, bottom (mm), shades (colours of 256 heights from bottom to top), stock [x0,y0,x1,y1] or null, stock_z
///         (its bottom) or null, world [x0,y0,x1,y1]; keep_outs [[x0,y0,x1,y1,z0,z1]]: clamps; tools [{n, d, r, f, a,
///         t, k, s, h, w}]: number, diameter, radius of the rounded edge, length of the flutes or null, of a cone mm
///         sideways for each mm of height or null, and diameter of its tip, of the shank (0: not known), mm from tip
///         to holder or null and the holder's diameter, words; features [{name, floor, top, path, time, left, gouge,
///         clean}]; sections [{label, feature, tool, first}]: index of the first move; faults [{kind, feature, x, y,
///         z, head, line, text}]; conditions [{name, text, line, met_by}]; figures of the whole; program: array of
///         lines.
/// Moves   kinds: one digit each (MoveKind); x, y, z: ends in um as differences from the previous move; t: durations
///         in 0.1 ms; line: differences; starts [[move, x, y, z]] for moves not beginning at the end of the previous
///         one; arcs [[move, cx, cy, turn]]: centre in um from the start of the move, turn +1 counter-clockwise;
///         feeds [[move, mm/min]] at changes of the feed; engagement: degrees, the largest on each move, or null;
///         force: N, likewise. Earlier null, or sections and columns of moves as above: cuts made before the program
///         begins. Sections have below: the height of the ceiling under which all is hollow, or null if open from
///         above.
std::string html_data(const Part& part, const Toolpath& toolpath, const Findings& findings,
                      const HtmlOptions& options);

}  // namespace clearcut::report
