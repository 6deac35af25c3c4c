// The shadow of a curved face in plan view.
#pragma once

#include <TopoDS_Face.hxx>
#include <vector>

#include "geometry/edge.h"

namespace clearcut {

/// The upward part of a face in plan view: counter-clockwise triangles that may overlap. The face's own triangulation
/// is replaced.
///
/// Error   their union ends within read::kCurveTolerance of the shadow's edge, and within a 20000th of the face's
///         size if that is more.
std::vector<Path> shadow_of(const TopoDS_Face& face);

}  // namespace clearcut
