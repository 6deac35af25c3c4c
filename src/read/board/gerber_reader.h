// Gerber layers of circuit boards; see docs/input.md.
#pragma once

#include <string>
#include <string_view>

#include "model/part.h"
#include "read/common/read_options.h"

namespace clearcut::read {

/// Reads one layer: copper is isolated (a band around every piece is milled, so that the piece remains and is
/// separated from the rest), the board's profile is cut out, drill files in Gerber's format are holes, and for other
/// layers the drawn areas are milled; rules override this. The purpose of a layer is given by its attribute
/// FileFunction, else by the name of the file.
///
/// Error   lines and arcs exact; mirrored or unevenly scaled blocks within kCurveTolerance.
/// Throws  InputError "file:line: ..." for damaged files, and if the layer's purpose is unknown and
///         options.ask_if_unclear.
Part read_gerber(std::string_view text, const std::string& file_name, const ReadOptions& options);

}  // namespace clearcut::read
