// The solids of a STEP file, with the names of their products.
#pragma once

#include <STEPControl_Reader.hxx>
#include <TopoDS_Solid.hxx>
#include <string>
#include <vector>

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

}  // namespace clearcut
