// SVG drawings; see docs/input.md.
#pragma once

#include <string>
#include <string_view>

#include "model/part.h"
#include "read/common/read_options.h"

namespace clearcut::read {

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
