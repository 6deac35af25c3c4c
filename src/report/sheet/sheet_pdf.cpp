#include "base/apart.h"
#include "base/error.h"
#include "base/programs.h"
#include "report/sheet/sheet_json.h"
#include "report/sheet/sheet_writers.h"

namespace clearcut::report {
namespace {

/// Seconds of the processor.
constexpr int kLongestDrawing = 120;

std::string drawer_of_pages() {
  return companion("clearcut-sheet", CLEARCUT_SHEET_INSTALLED);
}

}  // namespace

void require_pdf(const std::string& file_name) {
  if (drawer_of_pages().empty())
    throw InputError(
        file_name,
        "this build writes no PDF; install librsvg2-dev, libpango1.0-dev and libcairo2-dev and build "
        "again, or name the set-up sheet .html, which any browser prints");
}

std::string setup_sheets_pdf(const std::vector<SetupSheet>& sheets, const std::string& file_name) {
  require_pdf(file_name);
  // Names out of drawings may be no UTF-8.
  const std::string text =
      nlohmann::json(sheets).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const auto pages = done_apart({drawer_of_pages()}, text, kLongestDrawing);
  if (!pages || pages->empty())
    throw InputError(file_name,
                     "its pages cannot be drawn; name the set-up sheet .html, which any browser prints");
  if (pages->front() == 'E') throw InputError(file_name, pages->substr(1));
  return *pages;
}

}  // namespace clearcut::report
