#include "base/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "base/text.h"

namespace clearcut::inline base {
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

/// A pipe like those of a shell, and like a device: what takes its place would be a file.
TEST_F(Files, PipesAreWrittenToAndStayPipes) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const int reader = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  write_files({{path("pipe"), "moves"}, {path("file"), "certificate"}});
  char got[16] = {};
  EXPECT_EQ(::read(reader, got, sizeof got), 5);
  EXPECT_STREQ(got, "moves");
  ::close(reader);
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
  EXPECT_EQ(read_file(path("file")), "certificate");
  EXPECT_EQ(count(), 2U);
}

/// A link stays a link, and what it points to is new.
TEST_F(Files, LinksAreFollowed) {
  write_files({{path("target"), "old"}});
  fs::create_symlink(path("target"), path("link"));
  write_files({{path("link"), "new"}});
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(read_file(path("target")), "new");
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
}  // namespace clearcut::inline base

namespace clearcut {
namespace {

/// The examples of the standard (FIPS 180-4).
TEST(Digest, IsThatOfTheStandard) {
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace
}  // namespace clearcut
