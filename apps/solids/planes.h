// Flat faces written as splines in a file.
#pragma once

#include <TopoDS_Shape.hxx>

namespace clearcut {

/// The shape with planes under those faces whose surfaces are flat within 0.1 um, but written as splines or
/// extrusions, as some programs write every surface. Edges, and the order and orientation of faces, stay.
TopoDS_Shape with_planes(const TopoDS_Shape& shape);

}  // namespace clearcut
