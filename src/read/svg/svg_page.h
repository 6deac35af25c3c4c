// From the user units of an SVG to mm.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "geometry/edge.h"
#include "read/common/affine.h"
#include "read/svg/svg_shapes.h"

namespace clearcut::read {

/// The attributes width, height, viewBox and preserveAspectRatio of an <svg>; "" when absent.
struct SvgViewport {
  std::string width, height, view_box, aspect;
};

struct SvgPage {
  Affine to_mm;           ///< map of the outermost user units to mm, y up
  double view_width = 0;  ///< user units, for percentages
  double view_height = 0;
  bool physical = false;  ///< the file states how large a user unit is
  bool has_size = false;  ///< the page's size is stated in mm or the like
};

/// Size of a px if the file states no physical size.
struct PixelSize {
  double per_inch = 96;
  std::string because;  ///< the program that wrote the file, if decisive
};
/// Adobe Illustrator writes points, Inkscape before 0.92 ninetieths of an inch. `text`: the file; `inkscape_version`:
/// the attribute of this name, "" if absent.
PixelSize pixel_size_of(std::string_view text, std::string_view inkscape_version);

/// The map of `svg_viewport` within `width` x `height` (its own viewport in outer units) for its viewBox.
Affine view_box_map(const std::string& view_box, const std::string& aspect, double width, double height);

/// Reference size of percentages within a viewport: that of its viewBox, `own` if it has none.
SvgViewSize view_size(const std::string& view_box, const SvgViewSize& own);

/// `user_unit`: mm per user unit if stated by the user; `px_per_inch` is used if no size is stated.
SvgPage page_of(const SvgViewport& viewport, std::optional<double> user_unit, double px_per_inch);

}  // namespace clearcut::read
