#include "base/programs.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace clearcut {
namespace {

TEST(Programs, TheOwnOneIsThisTest) {
  EXPECT_EQ(std::filesystem::path(own_program()).filename(), program_file("base_test"));
  EXPECT_EQ(companion("base_test"), own_program());
  EXPECT_EQ(companion("no_such_program"), "");
}

/// The examples of "Parsing C++ command-line arguments" in Microsoft's manual, the other way round.
TEST(Programs, WordsOfACommandLineAreTakenApartAsTheyWere) {
  EXPECT_EQ(command_line({"clearcut", "plan", "-o", ""}), "clearcut plan -o \"\"");
  EXPECT_EQ(command_line({"a b c", "d", "e"}), "\"a b c\" d e");
  EXPECT_EQ(command_line({"ab\"c", "\\", "d"}), "\"ab\\\"c\" \\ d");
  EXPECT_EQ(command_line({"a\\\\\\b", "de fg", "h"}), "a\\\\\\b \"de fg\" h");
  EXPECT_EQ(command_line({"a\\\"b"}), "\"a\\\\\\\"b\"");
  EXPECT_EQ(command_line({"C:\\My Parts\\", "{\"port\":0}"}), "\"C:\\My Parts\\\\\" \"{\\\"port\\\":0}\"");
}

}  // namespace
}  // namespace clearcut
