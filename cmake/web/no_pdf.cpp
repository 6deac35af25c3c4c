// Stands in for src/report/sheet/sheet_pdf.cpp: neither a page nor Clearcut for Windows has what draws PDF.
#include "base/error.h"
#include "report/sheet/sheet_writers.h"

#ifndef CLEARCUT_HERE
#define CLEARCUT_HERE "this page"
#endif

namespace clearcut::report {

void require_pdf(const std::string& file_name) {
  throw InputError(file_name,
                   CLEARCUT_HERE " writes no PDF; name the set-up sheet .html, which a browser prints");
}

std::string setup_sheets_pdf(const std::vector<SetupSheet>& /*sheets*/, const std::string& file_name) {
  require_pdf(file_name);
  return {};
}

}  // namespace clearcut::report
