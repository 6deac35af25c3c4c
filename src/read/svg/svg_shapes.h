// SVG shape elements as subpaths.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "read/svg/svg_path.h"

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
