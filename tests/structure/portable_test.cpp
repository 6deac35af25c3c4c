// What the pipeline takes from the C++ library exists in that of the web build (libc++ 14 of Debian's emscripten), which lacks
// parts of C++20: found here at once, and not by the build that takes longest.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "base/file.h"
#include "support/sources/tokens.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;
using test_support::Token;
using test_support::tokens_of;
using testing::ElementsAre;
using testing::IsEmpty;

/// Of those of C++20; what cmake/web/include stands in for is none of them.
const std::set<std::string> kMissing{"ranges",          "views",     "format",     "barrier",
                                     "source_location", "execution", "osyncstream"};

/// "line name" of each use.
std::vector<std::string> missing_names(std::string_view text) {
  const std::vector<Token> tokens = tokens_of(text);
  std::vector<std::string> found;
  for (std::size_t i = 2; i < tokens.size(); ++i) {
    const bool is_library = tokens[i - 1].text == "::" && tokens[i - 2].text == "std";
    if (is_library && kMissing.count(tokens[i].text) > 0)
      found.push_back(std::to_string(tokens[i].line) + " " + tokens[i].text);
  }
  return found;
}

TEST(Portable, WhatIsMissingElsewhereIsFound) {
  EXPECT_THAT(missing_names("void f() {\n  std::ranges::sort(a);\n  std::format(x);\n}"),
              ElementsAre("2 ranges", "3 format"));
  EXPECT_THAT(missing_names("// std::ranges::sort\nvoid f() { std::sort(a); fmt::format(\"std::views\"); }"),
              IsEmpty());
}

TEST(Portable, ThePipelineNeedsNothingThatTheWebBuildLacks) {
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(CLEARCUT_SOURCE_DIR) / "src")) {
    const fs::path& file = entry.path();
    if ((file.extension() != ".h" && file.extension() != ".cpp") || file.stem().string().ends_with("_test"))
      continue;
    ++files;
    for (const std::string& name : missing_names(read_file(file.string())))
      ADD_FAILURE() << fs::relative(file, CLEARCUT_SOURCE_DIR).string() << ":" << name
                    << ": the web build's C++ library has none";
  }
  EXPECT_GT(files, 500);
}

}  // namespace
}  // namespace clearcut
