#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "base/file.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;

class OutputNames : public ::testing::Test {
 protected:
  OutputNames() {
    std::string pattern = (fs::temp_directory_path() / "guard_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    std::ofstream(path("in.dxf")) << "a drawing";
  }
  ~OutputNames() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string read() const { return read_file(path("in.dxf")); }
  void expect_refused(const std::string& output) const {
    EXPECT_THROW(write_files({{output, "a program"}}, {path("in.dxf")}), InputError) << output;
    EXPECT_EQ(read(), "a drawing") << output;
  }
  fs::path folder_;
};

TEST_F(OutputNames, WhatWasReadIsNotReplacedByAnyName) {
  fs::create_symlink(path("in.dxf"), path("soft"));
  fs::create_hard_link(path("in.dxf"), path("hard"));
  fs::create_directory(path("sub"));
  for (const char* name : {"in.dxf", "./in.dxf", "sub/../in.dxf", "soft", "hard"}) expect_refused(path(name));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 4);
}

TEST_F(OutputNames, OutputsAreDifferentFiles) {
  EXPECT_THROW(write_files({{path("a"), "1"}, {path("./a"), "2"}}), InputError);
  EXPECT_THROW(check_outputs({"-", "/dev/stdout"}), InputError);
  EXPECT_THROW(check_outputs({path("none/a")}), InputError);
  EXPECT_THROW(check_outputs({folder_.string()}), InputError);
  EXPECT_NO_THROW(check_outputs({"/dev/null", "/dev/null", path("a"), path("b")}));
  EXPECT_FALSE(fs::exists(path("a")));
}

TEST_F(OutputNames, LinksToWhatDoesNotExistYetAreOneFile) {
  fs::create_symlink(path("later"), path("link"));
  EXPECT_TRUE(is_same_file(path("later"), path("link")));
  write_files({{path("link"), "a program"}});
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(read_file(path("later")), "a program");
}

}  // namespace
}  // namespace clearcut
