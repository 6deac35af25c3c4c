// Role of each outline of a drawing: by its layer, by options naming outlines, or by asking.
#pragma once

#include <string>
#include <vector>

#include "read/drawing/drawing.h"

namespace clearcut::read {

/// A group with its curves made into areas, or into lines to engrave.
struct ShapedGroup {
  DrawnGroup group;  ///< without curves
  Regions regions;
  std::vector<CrossingOutline> crossing;  ///< outlines in no region
  std::vector<Path> lines;
};

/// A layer of the drawing, and whether anything on it was read.
struct NamedLayer {
  std::string name;
  bool has_outlines = false;
};

/// Gives outlines named in options ("outer", "2,5") their own group, fills in options.overview, and asks for the role
/// of the outermost outline if it is unclear and options.ask_if_unclear. Throws InputError for options without a
/// match, and for crossing outlines that are not left out; in an overview they are listed. Cost O(n log n) for n
/// outlines.
void assign_outline_roles(std::vector<ShapedGroup>& groups, const std::vector<NamedLayer>& layers,
                          const ReadOptions& options, const std::string& file, Diagnostics& diagnostics);

/// The curves chained at common ends, open or closed, in their order. Cost O(n log n) unless many ends meet.
std::vector<Path> chained_lines(const std::vector<RawCurve>& curves, double gap);

}  // namespace clearcut::read
