// Rotation of a solid before it is viewed from above, and the rotations that turn its flat sides up.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "read/step_solid/solid_model.h"

namespace clearcut {

/// The shape rotated so that `up` ("+Z", "-Z", "+X", "-X", "+Y", "-Y", or "faceN" for the N-th face's outside) faces
/// +Z, then by `degrees` counter-clockwise about Z seen from above; both about the file's origin. Quarter turns are
/// exact.
///
/// Throws  InputError if `up` is none of these, or the face is not flat or does not exist.
TopoDS_Shape placed(const TopoDS_Shape& shape, const std::string& up, double degrees,
                    const std::string& file_name);

/// The flat sides of a shape by the direction they look in, largest area first, then most heights. `degrees` of turn
/// make no difference. Faces are numbered in the shape's order from 1.
std::vector<read::FlatSide> flat_sides(const TopoDS_Shape& shape);

}  // namespace clearcut
