// Set-up sheets as files: their kind is given by the ending of their names.
#pragma once

#include <clearcut/report.h>

#include <string>
#include <vector>

namespace clearcut::cli {

/// Throws InputError before planning if the name requires a PDF that this build cannot write.
void check_setup_sheet_name(const std::string& path);

/// PDF for names in .pdf, else HTML.
std::string setup_sheet_file(const std::string& path, const SetupSheet& sheet);
/// Those of a job of several set-ups, each on a sheet of its own.
std::string setup_sheets_file(const std::string& path, const std::vector<SetupSheet>& sheets);

}  // namespace clearcut::cli
