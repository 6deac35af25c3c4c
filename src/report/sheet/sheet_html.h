// Set-up sheets as pages for a browser.
#pragma once

#include <string>
#include <vector>

#include "report/sheet/setup_sheet.h"

namespace clearcut::report {

/// A well-formed HTML page for one printed sheet; every text is escaped.
std::string setup_sheet_html(const SetupSheet& sheet);

/// Sheets of one job as one page, printed with each on its own sheet.
std::string joined_setup_sheets(const std::vector<std::string>& sheets);

}  // namespace clearcut::report
