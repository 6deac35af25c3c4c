// Set-up sheets as pages of paper.
#pragma once

#include <string>
#include <vector>

#include "report/sheet/setup_sheet.h"

namespace clearcut::report {

/// Throws InputError naming the file that was to be written where the program that draws pages (apps/sheet) lies neither beside
/// this one nor where it is installed.
void require_pdf(const std::string& file_name);

/// Sheets on pages of A4, each from a page of its own on; tables that go on repeat their heads. Text can be searched and copied.
/// The same sheets give the same bytes where the same fonts are installed: no date.
/// Throws  as require_pdf(), and where no font is installed.
/// Cost    some 50 ms, for the program and its libraries.
std::string setup_sheets_pdf(const std::vector<SetupSheet>& sheets, const std::string& file_name);

}  // namespace clearcut::report
