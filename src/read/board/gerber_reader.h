// Gerber layers of circuit boards; see docs/input.md.
#pragma once

#include <string>
#include <string_view>

#include "model/part.h"
#include "read/common/read_options.h"

namespace clearcut::read {

/// Reads one layer: copper is isolated (a band around every piece of it is milled, so that it stays and is parted from the rest), the
/// board's profile is cut out, drill files in Gerber's format are holes, and of other layers what is drawn is milled; rules
/// overrule that. What a layer is for is its attribute FileFunction, else the name of the file.
///
/// Error   lines and arcs exact; mirrored or unevenly scaled blocks within kCurveTolerance.
/// Throws  InputError "file:line: ..." for damaged files, and where nothing says what the layer is for and
///         options.ask_if_unclear.
Part read_gerber(std::string_view text, const std::string& file_name, const ReadOptions& options);

}  // namespace clearcut::read
