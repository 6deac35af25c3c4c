// Set-up sheets laid out on paper.
#pragma once

#include <string>
#include <vector>

#include "report/sheet/setup_sheet.h"

namespace clearcut::sheet {

/// A PDF with each sheet on one page if it fits, each beginning on its own page. Throws std::runtime_error with one
/// line if no font is installed, or a picture cannot be drawn.
std::string pages_of(const std::vector<report::SetupSheet>& sheets);

}  // namespace clearcut::sheet
