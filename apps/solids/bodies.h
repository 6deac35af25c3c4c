// The solids of a STEP file, with the names of their products, their rotation before they are viewed from above, and
// the rotations that turn their flat sides up.
#pragma once

#include <STEPControl_Reader.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <string>
#include <vector>

#include "read/step_solid/solid_model.h"

namespace clearcut {

struct NamedBody {
  TopoDS_Solid solid;  ///< at its place in the assembly
  std::string name;    ///< "" for none
};

/// Every solid of every root, instances of one solid one by one, in the order of the file.
std::vector<NamedBody> bodies_of(STEPControl_Reader& reader, const TopoDS_Shape& shape);

/// The bodies named by `choice`: by number from 1, by name (any case), "all", or the only one if it is empty. Of
/// instances of one solid the first. Nothing if several are left and none is named.
///
/// Throws  InputError if no body has this name or number, or different ones share it.
std::vector<NamedBody> chosen(const std::vector<NamedBody>& bodies, const std::string& choice,
                              const std::string& file_name);

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
