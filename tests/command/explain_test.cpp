// What a plan was made with and where it comes from; strategies that files name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "base/file.h"
#include "support/command.h"

namespace clearcut {
namespace {

using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

constexpr const char* kPocket = R"({"units": "mm", "depth": 4, "outer": [[0,0],[50,0],[50,30],[0,30]]})";

std::string job_with(const std::string& plan, const std::string& operation) {
  return "[part]\nfile = \"pocket.json\"\n\n[[tool]]\nnumber = 1\nkind = \"endmill\"\ndiameter = 8\nfeed = "
         "900\n\n[plan]\n" +
         plan + "\n[[operation]]\nfeature = \"*\"\n" + operation;
}

TEST(Explain, PrintsEveryValueWithItsOrigin) {
  const ScratchFolder folder;
  folder.file("pocket.json", kPocket);
  const auto job = folder.file("job.toml", job_with("stepdown = 2\n", "ramp_feed = 250\n"));
  const auto result = run_clearcut({"plan", job, "--explain", "--plunge-feed", "200", "--seed", "7"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, ContainsRegex("plunge-feed +200 +mm/min +user +--plunge-feed"));
  EXPECT_THAT(result.out, ContainsRegex("stepdown +2 +mm +job file +[^ ]*job.toml:11"));
  EXPECT_THAT(result.out, ContainsRegex("ramp-feed +250 +mm/min +job file +[^ ]*job.toml:15"));
  EXPECT_THAT(result.out, ContainsRegex(" feed +900 +mm/min +job file +[^ ]*job.toml T1"));
  EXPECT_THAT(result.out, ContainsRegex("whole plan +seed +7 +user +--seed"));
  EXPECT_THAT(result.out, ContainsRegex("whole plan +acceleration +500 +mm/s2 +default"));
}

TEST(Explain, TheCertificateListsTheSameValues) {
  const ScratchFolder folder;
  const auto part = folder.file("pocket.json", kPocket);
  const auto result = run_clearcut({"plan", part, "--tool", "endmill:8", "--feed", "800", "-o",
                                    folder.path("a.ngc"), "--certificate", folder.path("a.cert"), "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::ifstream file(folder.path("a.cert"));
  const auto json = nlohmann::json::parse(file);
  bool found = false;
  for (const auto& value : json.at("values")) {
    for (const char* key : {"workingstep", "name", "value", "unit", "origin", "source"})
      ASSERT_TRUE(value.contains(key)) << key;
    if (value.at("name") != "feed") continue;
    found = true;
    EXPECT_EQ(value.at("value"), "800");
    EXPECT_EQ(value.at("origin"), "user");
    EXPECT_EQ(value.at("source"), "--feed");
  }
  EXPECT_TRUE(found);
}

TEST(JobStrategy, OfAnOperationIsPlanned) {
  const ScratchFolder folder;
  folder.file("pocket.json", kPocket);
  const auto job = folder.file("job.toml", job_with("", "strategy = \"zigzag\"\n"));
  const auto plan = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{
        "plan", job, "-o", folder.path("a.ngc"), "--certificate", folder.path("a.cert"), "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run_clearcut(arguments).exit_code, 0);
    std::ifstream file(folder.path("a.cert"));
    return nlohmann::json::parse(file).at("features").at(0).at("strategy").get<std::string>();
  };
  EXPECT_EQ(plan({}), "zigzag");
  EXPECT_EQ(plan({"--strategy", "spiral"}), "spiral");
}

TEST(JobStrategy, ThatIsNoneIsRefusedInOneLine) {
  const ScratchFolder folder;
  folder.file("pocket.json", kPocket);
  for (const auto& text :
       {job_with("strategy = \"nonsense\"\n", ""), job_with("", "strategy = \"nonsense\"\n")}) {
    const auto job = folder.file("job.toml", text);
    const auto result = run_clearcut({"plan", job, "-o", folder.path("a.ngc")});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, AllOf(HasSubstr("job.toml:1"), HasSubstr("strategy 'nonsense' is unknown"),
                                  HasSubstr("auto, zigzag, spiral, adaptive, tour, cover, contour, lom")));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1);
  }
}

/// Arguments of the command, not of a plan.
const std::set<std::string> kNotOfJobs{"--animation", "--earlier-setup", "--explain",
                                       "--help",      "--quiet",         "--setup"};

TEST(JobKeys, AreThereForEveryOptionOfPlan) {
  const ScratchFolder folder;
  const auto part = folder.file("pocket.json", kPocket);
  const std::string job = run_clearcut({"init", part}).out;
  const std::string help = run_clearcut({"plan", "--help", "all"}).out;
  const std::regex option("\n +(?:-o, )?(--[a-z-]+)");
  int options = 0;
  for (std::sregex_iterator at(help.begin(), help.end(), option), end; at != end; ++at) {
    const std::string name = (*at)[1];
    if (kNotOfJobs.contains(name)) continue;
    ++options;
    std::string key = name.substr(name.starts_with("--no-") ? 5 : 2);
    std::replace(key.begin(), key.end(), '-', '_');
    if (key == "machine_kind") key = "kind";
    EXPECT_TRUE(std::regex_search(job, std::regex("\\b" + key + "\\b"))) << name << " has no key in\n" << job;
  }
  EXPECT_GT(options, 70);
}

TEST(JobKeys, SayWhatTheCommandLineSays) {
  const ScratchFolder folder;
  const auto part = folder.file("pocket.json", kPocket);
  const std::string plan =
      "strategy = \"contour\"\ndirection = \"conventional\"\norder = \"outside-in\"\nstart = [40, 10]\n";
  const std::string output = "[output]\npost = \"fanuc\"\nprogram_number = 12\nblock_numbers = true\n";
  const auto job = folder.file("job.toml", job_with(plan, "stepdown = 2\n") + output);
  const auto typed = run_clearcut({"plan",
                                   part,
                                   "--tool",
                                   "endmill:8",
                                   "--feed",
                                   "900",
                                   "--strategy",
                                   "contour",
                                   "--direction",
                                   "conventional",
                                   "--order",
                                   "outside-in",
                                   "--start",
                                   "40,10",
                                   "--stepdown",
                                   "2",
                                   "--post",
                                   "fanuc",
                                   "--program-number",
                                   "12",
                                   "--block-numbers",
                                   "-o",
                                   folder.path("typed.nc"),
                                   "--quiet"});
  ASSERT_EQ(typed.exit_code, 0) << typed.err;
  const auto said = run_clearcut({"plan", job, "-o", folder.path("said.nc"), "--quiet"});
  ASSERT_EQ(said.exit_code, 0) << said.err;
  EXPECT_EQ(read_file(folder.path("said.nc")), read_file(folder.path("typed.nc")));
  EXPECT_THAT(read_file(folder.path("said.nc")), HasSubstr("O0012"));
}

}  // namespace
}  // namespace clearcut
