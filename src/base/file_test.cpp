#include "base/file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "base/format.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  fs::path folder_ =
      fs::temp_directory_path() /
      (std::string("clearcut_file_test_") + testing::UnitTest::GetInstance()->current_test_info()->name() +
       std::to_string(getpid()));
};

TEST_F(Files, WhatIsWrittenIsRead) {
  write_files({{path("a"), "one\n"}, {path("b"), std::string("\0two", 4)}});
  EXPECT_EQ(read_file(path("a")), "one\n");
  EXPECT_EQ(read_file(path("b")), std::string("\0two", 4));
  EXPECT_EQ(count(), 2u);
}

TEST_F(Files, OneBadTargetLeavesAllOthersUntouched) {
  write_files({{path("a"), "old"}});
  EXPECT_THROW(write_files({{path("a"), "new"}, {path("missing/b"), "x"}}), InputError);
  EXPECT_EQ(read_file(path("a")), "old");
  EXPECT_EQ(count(), 1u);
}

TEST_F(Files, UnreadableInputIsNamed) {
  try {
    read_file(path("none"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), path("none") + ": no such file; check the name");
  }
  EXPECT_THROW(read_file(folder_.string()), InputError);
  write_files({{path("large"), std::string(100, 'x')}});
  EXPECT_THROW(read_file(path("large"), 99), InputError);
}

TEST(Format, NumbersAreTrimmedAndNeverNegativeZero) {
  EXPECT_EQ(trimmed(1.5, 3), "1.5");
  EXPECT_EQ(trimmed(2.0, 3), "2");
  EXPECT_EQ(trimmed(-0.0004, 3), "0");
  EXPECT_EQ(trimmed(-0.0006, 3), "-0.001");
  EXPECT_EQ(trimmed(100, 0), "100");
}

}  // namespace
}  // namespace clearcut
