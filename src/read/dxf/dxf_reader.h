// DXF drawings; see docs/input.md.
#pragma once

#include <string>
#include <string_view>

#include "model/part.h"
#include "options/read_options.h"

namespace clearcut::read {

/// Reads LINE, ARC, CIRCLE, ELLIPSE, SPLINE, LWPOLYLINE, POLYLINE and INSERT (blocks in blocks, scaled,
/// turned, mirrored, repeated) of model space. Loose segments are chained; layers group outlines of one
/// depth (meaning_of_layer).
///
/// Units   options.unit, else $INSUNITS, else millimetres with a warning.
/// Error   ellipses, splines and stretched arcs within kCurveTolerance; all else exact.
/// Throws  InputError "file:line: ..." for damaged files and outlines beyond repair (see repair.h).
///         Entities other than outlines are counted and named in the diagnostics.
Part read_dxf(std::string_view text, const std::string& file_name, const ReadOptions& options);

}  // namespace clearcut::read
