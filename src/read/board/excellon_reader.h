// Drill files of circuit boards (Excellon, XNC); see docs/input.md.
#pragma once

#include <string>
#include <string_view>

#include "model/part.h"
#include "read/common/read_options.h"

namespace clearcut::read {

/// Holes by tools, each a layer "T1" with the diameter in its name, and slots, as wide as their tool, as pockets.
///
/// Throws  InputError "file:line: ..." for damaged files, tools without a diameter, and unsupported motion commands
/// (patterns, routed arcs). Source: XNC Format Specification, revision 2021.11 (Ucamco); commands of older Excellon
/// machines as far as CAD programs write them.
Part read_excellon(std::string_view text, const std::string& file_name, const ReadOptions& options);

}  // namespace clearcut::read
