// SVG drawings, see docs/input.md, and items of a drawing left out, or read differently than drawn.
#pragma once

#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "model/part.h"
#include "options/read_options.h"
#include "read/drawing/drawing.h"

namespace clearcut::read {

/// Counted while the elements are read.
struct SvgNotes {
  LeftOut not_read, hidden, not_chosen, ignored;
  LeftOut shapes_not_read;  ///< unknown elements that may draw shapes to be cut
  LeftOut texts_not_read;
  LeftOut letters_not_so;  ///< texts by their unsupported property
  LeftOut not_applied;     ///< elements by the property hiding part of them
  int clipped = 0;         ///< shapes with a hidden part, which is left out
  int clipped_lines = 0;   ///< lines with a possibly hidden part, read whole
  int stroke_only = 0;
  int dashed = 0;
  int fixed_strokes = 0;
  int marked = 0;
  int even_odd_strokes = 0;
  int odd_points = 0;
  int filtered = 0;  ///< elements with a filter

  void report(Diagnostics& diagnostics, const std::string& file) const;
};

/// Reads rect, circle, ellipse, line, polyline, polygon, path and use, with nested transforms, viewBox,
/// physical units and fill rules. Filled shapes are areas; shapes with a stroke only are outlines like
/// those of a DXF.
///
/// Axes    y points up: the lower left corner of the page is the origin.
/// Depth   data-depth and data-top (a length, mm without unit) of the element or a group around it; else
///         the rule for its colour or layer; else the layer's name (inkscape:label or id of a group), in
///         mm; else the options.
/// Units   options.unit per user unit, else width, height and viewBox, else 96 px per inch with a warning.
/// Error   curves within kCurveTolerance, circular arcs exact.
/// Throws  InputError "file:line: ..." for damaged files and outlines beyond repair (see repair.h). Unread elements
///         (text, images, ...) are counted and named in the diagnostics.
Part read_svg(std::string_view text, const std::string& file_name, const ReadOptions& options);

}  // namespace clearcut::read
