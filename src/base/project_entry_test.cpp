#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "base/file.h"

namespace clearcut::inline base {
namespace {

/// A project file of a few files in the folder for temporary files.
struct ProjectEntry : testing::Test {
  ProjectEntry() {
    std::ofstream(path) << R"({"clearcut": "project", "version": 1, "files": [
      {"name": "plate.dxf", "text": "0\nEOF\n"}, {"name": "raw.bin", "base64": "AP8QgA=="},
      {"name": "bad.bin", "base64": "A*=="}, {"name": "none"}]})";
  }
  ~ProjectEntry() override { std::filesystem::remove(path); }
  /// One for each process: tests run beside each other.
  const std::string path = (std::filesystem::temp_directory_path() /
                            ("entry_test_" + std::to_string(::getpid()) + ".clearcut.json"))
                               .string();
};

TEST_F(ProjectEntry, PathsLeadIntoProjectFilesThatThereAre) {
  const auto within = project_path(path + "/plate.dxf");
  ASSERT_TRUE(within);
  EXPECT_EQ(within->project, path);
  EXPECT_EQ(within->entry, "plate.dxf");
  EXPECT_FALSE(project_path(path));
  EXPECT_FALSE(project_path("/nowhere/a.clearcut.json/plate.dxf"));
}

TEST_F(ProjectEntry, FilesWithinAreReadAsFilesAre) {
  EXPECT_EQ(read_file(path + "/plate.dxf"), "0\nEOF\n");
  EXPECT_EQ(read_file(path + "/raw.bin"), std::string("\0\xff\x10\x80", 4));
  EXPECT_TRUE(is_file(path + "/raw.bin"));
  EXPECT_TRUE(is_file(path));
  EXPECT_FALSE(is_file(path + "/other.dxf"));
}

TEST_F(ProjectEntry, WhatIsNotThereIsRefused) {
  EXPECT_THROW(read_file(path + "/other.dxf"), InputError);
  EXPECT_THROW(read_file(path + "/bad.bin"), InputError);
  EXPECT_THROW(read_file(path + "/none"), InputError);
  std::ofstream(path) << "no JSON";
  EXPECT_THROW(read_file(path + "/plate.dxf"), InputError);
}

}  // namespace
}  // namespace clearcut::inline base
