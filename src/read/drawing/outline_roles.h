// What each outline of a drawing is for: by its layer, by options that name outlines, or by asking.
#pragma once

#include <string>
#include <vector>

#include "read/drawing/drawing.h"

namespace clearcut::read {

/// A group with its curves made into areas, or into lines to engrave.
struct ShapedGroup {
  DrawnGroup group;  ///< without curves
  Regions regions;
  std::vector<CrossingOutline> crossing;  ///< which are in no region
  std::vector<Path> lines;
};

/// A layer of the drawing, and whether anything on it was read.
struct NamedLayer {
  std::string name;
  bool has_outlines = false;
};

/// Gives outlines that options name ("outer", "2,5") a group of their own, fills in options.overview, and asks what the
/// outermost outline is where that is unclear and options.ask_if_unclear. Throws InputError for options that match nothing, and for
/// outlines that cross and are not left out; in an overview they are listed.
/// Cost O(n log n) for n outlines.
void assign_outline_roles(std::vector<ShapedGroup>& groups, const std::vector<NamedLayer>& layers,
                          const ReadOptions& options, const std::string& file, Diagnostics& diagnostics);

/// The curves chained where their ends meet, open or closed, in their order. Cost O(n log n) unless many ends meet.
std::vector<Path> chained_lines(const std::vector<RawCurve>& curves, double gap);

}  // namespace clearcut::read
