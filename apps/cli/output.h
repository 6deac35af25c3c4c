// What the commands print and write.
#pragma once

#include <string>

#include "base/diagnostics.h"

namespace clearcut::cli {

/// Diagnostics as lines on standard error: "repair: where: what". Notes only when `verbose`.
void print(const Diagnostics& diagnostics, bool verbose);
/// The same of warnings alone: beside an error that ends the command.
void print_warnings(const Diagnostics& diagnostics);
void print_line(const std::string& text);

}  // namespace clearcut::cli
