// SVG path data as lines and arcs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/edge.h"
#include "read/common/affine.h"
#include "read/drawing/subpath.h"

namespace clearcut::read {

struct SvgPathData {
  std::vector<Subpath> subpaths;
  bool half_point = false;  ///< a list of points ends after an x
  std::string error;        ///< "" or the fault and its place; the subpaths before are valid
};

/// All commands in absolute and relative form, with implied repeats. Circular arcs stay exact under `map`
/// if it is a similarity; all other curves are within kCurveTolerance. Cost O(length + pieces).
SvgPathData read_svg_path(std::string_view data, const Affine& map);

}  // namespace clearcut::read
