// Sines, logarithms and their kin come from base/elementary.h alone: the C library's differ in the last bit between
// processors, and programs are to be the same on all.
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

const std::set<std::string> kFunctions{"sin",   "cos",  "tan",  "asin",  "acos",  "atan",   "atan2",
                                       "sinh",  "cosh", "tanh", "asinh", "acosh", "atanh",  "exp",
                                       "exp2",  "log",  "log2", "log10", "log1p", "expm1",  "pow",
                                       "hypot", "cbrt", "erf",  "erfc",  "fma",   "tgamma", "lgamma"};

/// "line name" of each use of the C library's: std::sin, ::sin, and a call without any namespace.
std::vector<std::string> library_calls(std::string_view text) {
  const std::vector<Token> tokens = tokens_of(text);
  const auto word = [&](std::size_t at) { return at < tokens.size() ? tokens[at].text : std::string(); };
  std::vector<std::string> found;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (kFunctions.count(word(i)) == 0) continue;
    const std::string before = i > 0 ? word(i - 1) : "", space = i > 1 ? word(i - 2) : "";
    const bool member = before == "." || (before == ">" && space == "-");
    const bool called = word(i + 1) == "(" && before != "::" && !member;
    const bool qualified = before == "::" && space != "base";
    if (called || qualified) found.push_back(std::to_string(tokens[i].line) + " " + word(i));
  }
  return found;
}

TEST(Elementary, CallsOfTheCLibraryAreFound) {
  EXPECT_THAT(library_calls("double f() {\n  return std::sin(1) + cos(2)\n + ::tan(3) + g(&std::exp);\n}"),
              ElementsAre("2 sin", "2 cos", "3 tan", "3 exp"));
  EXPECT_THAT(library_calls("// std::sin(x)\nbool log = base::sin(x) > a.exp(1) + b->log(2) + std::sqrt(x);"),
              IsEmpty());
}

TEST(Elementary, TheSameOnEveryProcessor) {
  int files = 0;
  for (const char* folder : {"src", "include", "apps", "python", "studies"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(CLEARCUT_SOURCE_DIR) / folder)) {
      const fs::path& file = entry.path();
      const std::string stem = file.stem().string();
      if (file.extension() != ".h" && file.extension() != ".cpp") continue;
      if (stem.ends_with("_test") || stem == "elementary") continue;
      ++files;
      for (const std::string& call : library_calls(read_file(file.string())))
        ADD_FAILURE() << fs::relative(file, CLEARCUT_SOURCE_DIR).string() << ":" << call
                      << ": use base:: of base/elementary.h";
    }
  }
  EXPECT_GT(files, 700);
}

}  // namespace
}  // namespace clearcut
