// Stands in for src/report/sheet/sheet_pdf.cpp: a page runs no other program.
#include "base/error.h"
#include "report/sheet/sheet_writers.h"

namespace clearcut::report {

void require_pdf(const std::string& file_name) {
  throw InputError(file_name,
                   "this page writes no PDF; name the set-up sheet .html, which the browser prints");
}

std::string setup_sheets_pdf(const std::vector<SetupSheet>& /*sheets*/, const std::string& file_name) {
  require_pdf(file_name);
  return {};
}

}  // namespace clearcut::report
