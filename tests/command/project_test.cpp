// Project files of the page: planned by the command they give the bytes of what they hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/file.h"
#include "support/command.h"

namespace clearcut {
namespace {

using nlohmann::json;
using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::HasSubstr;

constexpr const char* kPocket = R"({"units": "mm", "depth": 2, "outer": [[0,0],[30,0],[30,20],[0,20]]})";
constexpr const char* kTools = "[[tool]]\nnumber = 3\nkind = \"endmill\"\ndiameter = 5\n";

std::string project(const std::string& input, const json& options, const json& files) {
  return json{{"clearcut", "project"},
              {"version", 1},
              {"plan", {{"input", input}, {"options", options}}},
              {"files", files}}
      .dump();
}

TEST(ProjectFile, GivesTheBytesOfItsPartAndOptions) {
  ScratchFolder folder;
  const auto part = folder.file("pocket.json", kPocket), tools = folder.file("tools.toml", kTools);
  const auto file = folder.file(
      "pocket.clearcut.json",
      project("pocket.json", {{"tools", {"tools.toml"}}, {"stepdown", {"0.7"}}, {"post", {"grbl"}}},
              {{{"name", "pocket.json"}, {"text", kPocket}}, {{"name", "tools.toml"}, {"text", kTools}}}));
  const auto program = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "plan");
    for (const std::string& one : {std::string("-o"), folder.path("a.nc"), std::string("--quiet")})
      arguments.push_back(one);
    const auto result = run_clearcut(arguments);
    EXPECT_NE(result.exit_code, 2) << result.err;
    return read_file(folder.path("a.nc"));
  };
  const std::string own = program({part, "--tools", tools, "--stepdown", "0.7", "--post", "grbl"});
  EXPECT_EQ(program({file}), own);
  // What is typed goes before what the project says.
  EXPECT_EQ(program({file, "--stepdown", "1"}),
            program({part, "--tools", tools, "--stepdown", "1", "--post", "grbl"}));
}

TEST(ProjectFile, CertificatesHoldForItAndItsJobStandsBesideIt) {
  ScratchFolder folder;
  const std::string job =
      "[part]\nfile = \"pocket.json\"\n[[tool]]\nkind = \"endmill\"\ndiameter = 5\n[output]\nprogram = "
      "\"out.nc\"\n";
  const auto file = folder.file("pocket.clearcut.json", project("pocket.toml", json::object(),
                                                                {{{"name", "pocket.json"}, {"text", kPocket}},
                                                                 {{"name", "pocket.toml"}, {"text", job}}}));
  const auto planned = run_clearcut({"plan", file, "--certificate", folder.path("c.json"), "--quiet"});
  ASSERT_NE(planned.exit_code, 2) << planned.err;
  EXPECT_THAT(read_file(folder.path("out.nc")), HasSubstr("G1"));
  const auto checked = run_clearcut({"check", folder.path("c.json"), "--again"});
  EXPECT_EQ(checked.exit_code, 0) << checked.out << checked.err;
}

TEST(ProjectFile, WhatIsNoneIsRefused) {
  ScratchFolder folder;
  const auto refused =
      run_clearcut({"plan", folder.file("a.clearcut.json", "{}"), "-o", folder.path("a.nc")});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("a.clearcut.json: is no project file; the page writes one with Save"));
}

}  // namespace
}  // namespace clearcut
