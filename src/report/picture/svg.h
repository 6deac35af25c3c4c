// A picture of the job for visual checks.
#pragma once

#include <string>

#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "model/results/margin.h"

namespace clearcut::report {

struct SvgOptions {
  std::string title;                  ///< default: the name of the part
  bool all_layers = false;            ///< false: each feature shows its last layer
  const Toolpath* earlier = nullptr;  ///< earlier cuts, already removed
  const Margin* margin = nullptr;     ///< allowed machine error, if it was asked for
};

/// Shape   one SVG document: verdict and figures, the whole part from above (floors in shades of depth), a
///         legend, and one panel for each feature: floor, rest (within reach red, out of reach amber), tool
///         impact, cuts, links, entries, rapids, worst places, faults. A part with one feature has only this panel,
///         large; with more than 36 features those that are not clean come first.
/// Units   paths are in mm in the part's own frame, arcs are true arcs; rests and gouges are drawn from the
///         moves' exact strips, not from the findings.
/// Text    names are escaped; non-finite moves are left out.
/// Cost    O(moves + boundary edges) per feature, and one Clearance of each.
std::string svg(const Part& part, const Toolpath& toolpath, const Findings& findings,
                const SvgOptions& options = {});

}  // namespace clearcut::report
