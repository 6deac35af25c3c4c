// What the commands print and write.
#pragma once

#include <string>

#include "base/diagnostics.h"

namespace clearcut::cli {

/// Diagnostics as lines on standard error: "repair: where: what". Notes only when `verbose`.
void print(const Diagnostics& diagnostics, bool verbose);
void print_line(const std::string& text);

}  // namespace clearcut::cli
