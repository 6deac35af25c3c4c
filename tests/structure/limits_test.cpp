// How large folders, files, functions and classes may grow.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "base/files/file.h"
#include "support/sources/functions.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;
using test_support::classes_of;
using test_support::functions_of;

constexpr int kMostFiles = 25;      // of one folder, beside its subfolders
constexpr int kMostLines = 450;     // of a file
constexpr int kLongest = 50;        // lines of a function
constexpr int kLongOfHundred = 31;  // lines that at most one function in a hundred has more than
constexpr int kMostMethods = 30;    // of a class

/// What somebody writes and reads. Golden programs and inputs of tests are data.
std::vector<fs::path> sources() {
  const fs::path root = CLEARCUT_SOURCE_DIR;
  std::vector<fs::path> files;
  for (const char* folder :
       {"src", "include", "apps", "studies", "tests", "examples", "benchmarks", "fuzz", "cmake", "scripts"}) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path name = fs::relative(entry.path(), root);
      const std::string extension = name.extension().string();
      const bool source = extension == ".h" || extension == ".cpp" || extension == ".js" ||
                          extension == ".css" || extension == ".mjs" || extension == ".py" ||
                          extension == ".sh" || extension == ".cmake";
      const bool data =
          name.string().starts_with("tests/golden") || name.string().starts_with("tests/corpus");
      if (entry.is_regular_file() && source && !data) files.push_back(name);
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string text_of(const fs::path& name) {
  return read_file((fs::path(CLEARCUT_SOURCE_DIR) / name).string());
}

bool is_cpp(const fs::path& name) {
  return name.extension() == ".cpp" || name.extension() == ".h";
}

TEST(Limits, FunctionsAndClassesAreFoundWithTheirSizes) {
  const std::string text =
      "namespace a {\ntemplate <class T>\nint f(T t) {\n  if (t) { return 1; }\n  return 0;\n}\n"
      "struct S : Base<int> {\n  S() : x{1}, y(2) {\n  }\n  int g() const;\n  int x, y = h(3);\n"
      "  std::function<int(int)> call;\n  bool operator()(int) const { return x < y; }\n};\n"
      "const auto v = [] {\n return 1; };\nenum class E { k };\nTEST(A, B) { f(1); }\n}";
  std::vector<std::string> found;
  for (const auto& one : functions_of(text))
    found.push_back(one.name + " " + std::to_string(one.line) + " " + std::to_string(one.lines));
  EXPECT_THAT(found, testing::ElementsAre("f 2 5", "S 8 2", "operator() 13 1", "TEST 18 1"));
  ASSERT_EQ(classes_of(text).size(), 1U);
  EXPECT_EQ(classes_of(text).front().name, "S");
  EXPECT_EQ(classes_of(text).front().methods, 3);
}

TEST(Limits, FoldersAreSmall) {
  std::map<fs::path, int> count;
  for (const fs::path& name : sources()) ++count[name.parent_path()];
  for (const auto& [folder, files] : count) EXPECT_LE(files, kMostFiles) << folder;
}

TEST(Limits, FilesAreShort) {
  for (const fs::path& name : sources()) {
    const std::string text = text_of(name);
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), kMostLines) << name;
  }
}

TEST(Limits, FunctionsAreShort) {
  std::vector<int> lengths;
  std::string longer;  // than what all but one in a hundred are to be
  for (const fs::path& name : sources()) {
    if (!is_cpp(name)) continue;
    for (const auto& one : functions_of(text_of(name))) {
      EXPECT_LE(one.lines, kLongest) << name << ":" << one.line << ": " << one.name;
      if (name.string().ends_with("_test.cpp")) continue;
      lengths.push_back(one.lines);
      if (one.lines > kLongOfHundred)
        longer += name.string() + ": " + one.name + " " + std::to_string(one.lines) + "\n";
    }
  }
  ASSERT_GT(lengths.size(), 3000U);
  std::sort(lengths.begin(), lengths.end());
  EXPECT_LE(lengths[lengths.size() * 99 / 100], kLongOfHundred) << longer;
}

TEST(Limits, ClassesAreSmall) {
  for (const fs::path& name : sources()) {
    if (!is_cpp(name)) continue;
    for (const auto& one : classes_of(text_of(name)))
      EXPECT_LE(one.methods, kMostMethods) << name << ":" << one.line << ": " << one.name;
  }
}

}  // namespace
}  // namespace clearcut
