// The job as input of the page's script: compact JSON. The script's side is in viewer/moves.js.
#pragma once

#include <string>

#include "report/viewer/html.h"

namespace clearcut::report {

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
