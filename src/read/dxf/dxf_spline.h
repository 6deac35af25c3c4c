// DXF SPLINE: rational B-splines, and cubics through fit points, as lines and arcs.
#pragma once

#include <optional>

#include "geometry/edge.h"
#include "read/common/affine.h"
#include "read/dxf/dxf_document.h"

namespace clearcut::read {

/// Group codes that differ between SPLINE and the boundaries of HATCH.
struct SplineCodes {
  int degree;
  int weight;
};

/// The spline of an entity's control points under `map`, within kCurveTolerance mm; nothing if it has none.
/// Throws  InputError "file:line: ..." when knots, weights and control points are inconsistent.
/// Source  de Boor's algorithm on homogeneous points, knot span by knot span.
std::optional<Path> spline_by_poles(const DxfDocument& document, const DxfEntity& entity,
                                    const SplineCodes& codes, const Affine& map);

/// The spline under `map`, within kCurveTolerance mm. Fit points are used if it has no control points; nothing if it
/// has neither.
/// Throws  as spline_by_poles() does.
std::optional<Path> spline_path(const DxfDocument& document, const DxfEntity& entity, const Affine& map);

}  // namespace clearcut::read
