// From the user units of an SVG to mm.
#pragma once

#include <optional>
#include <string>

#include "read/common/affine.h"

namespace clearcut::read {

/// The attributes width, height, viewBox and preserveAspectRatio of an <svg>; "" when absent.
struct SvgViewport {
  std::string width, height, view_box, aspect;
};

struct SvgPage {
  Affine to_mm;           ///< of the outermost user units, y up
  double view_width = 0;  ///< user units, for percentages
  double view_height = 0;
  bool physical = false;  ///< the file states a physical size
};

/// The map of `svg_viewport` within `width` x `height` (its own viewport in outer units) for its viewBox.
Affine view_box_map(const std::string& view_box, const std::string& aspect, double width, double height);

/// `user_unit`: mm per user unit when the user states it.
SvgPage page_of(const SvgViewport& viewport, std::optional<double> user_unit);

}  // namespace clearcut::read
