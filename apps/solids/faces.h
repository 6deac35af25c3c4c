// Faces of a solid: boxes round them, planes where a file has them as splines, the shadow of a curved face in plan
// view.
#pragma once

#include <Bnd_Box.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "geometry/edge.h"

namespace clearcut {

/// A box around the face, possibly larger: by the kernel's tolerances, and for splines by the box of their poles. The
/// kernel's own boxes may be narrower than the face. For part of a torus they may ignore its thickness (a bent rod
/// with its seam on the inside, 7.6), so this box is computed here, exactly for a patch between two meridians and two
/// parallels; for free surfaces they may miss the edges, so the boxes of the edges are added.
Bnd_Box box_of(const TopoDS_Face& face);

/// The same round all faces of a shape.
Bnd_Box box_of_faces(const TopoDS_Shape& shape);

/// The shape with planes under those faces whose surfaces are flat within 0.1 um, but written as splines or
/// extrusions, as some programs write every surface. Edges, and the order and orientation of faces, stay.
TopoDS_Shape with_planes(const TopoDS_Shape& shape);

/// The upward part of a face in plan view: counter-clockwise triangles that may overlap. The face's own triangulation
/// is replaced.
///
/// Error   their union ends within read::kCurveTolerance of the shadow's edge, and within a 20000th of the face's
///         size if that is more.
std::vector<Path> shadow_of(const TopoDS_Face& face);

}  // namespace clearcut
