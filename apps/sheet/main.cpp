// clearcut-sheet < sheets > pages: draws set-up sheets (JSON, report/sheet/sheet_json.h) as PDF for clearcut.
//
// A separate program, because loading the text layout libraries takes longer than planning a pocket.
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "report/sheet/sheet_json.h"
#include "sheet_pages.h"

namespace {

/// The pages, or after an 'E' in one line why there are none.
std::string answer(const std::string& text) {
  try {
    return clearcut::sheet::pages_of(nlohmann::json::parse(text).get<std::vector<clearcut::SetupSheet>>());
  } catch (const std::exception& error) {
    return std::string("E") + error.what();
  }
}

}  // namespace

int main(int count, char** /*arguments*/) {
  if (count != 1) {
    std::cerr << "usage: clearcut-sheet < sheets.json > pages.pdf\n";
    return 2;
  }
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  const std::string pages = answer(text);
  const bool written = std::fwrite(pages.data(), 1, pages.size(), stdout) == pages.size();
  // Skips the libraries' own shutdown: fonts kept until the end are not released one by one.
  _exit(written && std::fflush(stdout) == 0 ? 0 : 1);
}
