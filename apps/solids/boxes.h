// Boxes round faces and bodies of a solid.
#pragma once

#include <Bnd_Box.hxx>
#include <TopoDS_Face.hxx>

namespace clearcut {

/// A box around the face, possibly larger: by the kernel's tolerances, and for splines by the box of their poles. The
/// kernel's own boxes may be narrower than the face. For part of a torus they may ignore its thickness (a bent rod
/// with its seam on the inside, 7.6), so this box is computed here, exactly for a patch between two meridians and two
/// parallels; for free surfaces they may miss the edges, so the boxes of the edges are added.
Bnd_Box box_of(const TopoDS_Face& face);

/// The same round all faces of a shape.
Bnd_Box box_of_faces(const TopoDS_Shape& shape);

}  // namespace clearcut
