#include "commands/setup_sheet_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace clearcut::cli {
namespace {

bool is_pdf(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending == ".pdf";
}

}  // namespace

void check_setup_sheet_name(const std::string& path) {
  if (is_pdf(path)) require_pdf(path);
}

std::string setup_sheet_file(const std::string& path, const SetupSheet& sheet) {
  return is_pdf(path) ? setup_sheets_pdf({sheet}, path) : setup_sheet_html(sheet);
}

std::string setup_sheets_file(const std::string& path, const std::vector<SetupSheet>& sheets) {
  if (is_pdf(path)) return setup_sheets_pdf(sheets, path);
  std::vector<std::string> pages;
  for (const SetupSheet& sheet : sheets) pages.push_back(setup_sheet_html(sheet));
  return joined_setup_sheets(pages);
}

}  // namespace clearcut::cli
