// Set-up sheets as pages for a browser and as pages of paper.
#pragma once

#include <string>
#include <vector>

#include "report/sheet/setup_sheet.h"

namespace clearcut::report {

/// A well-formed HTML page for one printed sheet; every text is escaped.
std::string setup_sheet_html(const SetupSheet& sheet);

/// Sheets of one job as one page, printed with each on its own sheet.
std::string joined_setup_sheets(const std::vector<std::string>& sheets);

/// Throws InputError naming the file to be written if the program that draws pages (apps/sheet) is found neither
/// beside this program nor at its installed place.
void require_pdf(const std::string& file_name);

/// Sheets on pages of A4, each beginning on its own page; continued tables repeat their heads. Text can be searched
/// and copied. The same sheets give the same bytes if the same fonts are installed: no date.
/// Throws  as require_pdf(), and if no font is installed.
/// Cost    some 50 ms, for the program and its libraries.
std::string setup_sheets_pdf(const std::vector<SetupSheet>& sheets, const std::string& file_name);

}  // namespace clearcut::report
