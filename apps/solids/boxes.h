// Boxes round faces and bodies of a solid.
#pragma once

#include <Bnd_Box.hxx>
#include <TopoDS_Face.hxx>

namespace clearcut {

/// A box that holds the face and may be larger: by the kernel's tolerances, and round splines by what their poles take.
/// The kernel's own boxes may be narrower than the face. Part of a torus may have none of its thickness (a bent rod whose seam
/// is on the inside, 7.6), so that is worked out here, exactly for what lies between two meridians and two parallels; free
/// surfaces may lack what lies along their edges, whose boxes are added.
Bnd_Box box_of(const TopoDS_Face& face);

/// The same round all faces of a shape.
Bnd_Box box_of_faces(const TopoDS_Shape& shape);

}  // namespace clearcut
