// SVG shape elements and path data as subpaths of lines and arcs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/edge.h"
#include "read/common/affine.h"
#include "read/drawing/stroke.h"

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

namespace pugi {
class xml_node;
}

namespace clearcut::read {

/// Size of the viewport in user units, for percentages.
struct SvgViewSize {
  double width = 0;
  double height = 0;

  /// Reference of percentages of neither width nor height: the diagonal over the root of two.
  double diagonal() const;
};

/// The name of an element without its namespace prefix.
std::string_view local_name(const pugi::xml_node& node);
/// rect, circle, ellipse, line, polyline, polygon, path.
bool is_svg_shape(std::string_view name);
/// The attribute as a length in user units; `otherwise` if absent or invalid.
double svg_attribute(const pugi::xml_node& node, const char* name, double whole, double otherwise);

/// The outline of a shape under `map`.
SvgPathData svg_shape(const pugi::xml_node& node, const SvgViewSize& view, const Affine& map);

}  // namespace clearcut::read
