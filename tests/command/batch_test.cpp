// clearcut batch: each part by itself, whatever becomes of the others; run again, only what changed is planned.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "support/command.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;
using test_support::CommandResult;
using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::HasSubstr;

std::string square(int side) {
  const std::string s = std::to_string(side);
  return R"({"name": "square", "units": "mm", "top": 0, "depth": 1, "outer": [[0, 0], [)" + s + ", 0], [" +
         s + ", " + s + "], [0, " + s + "]]}";
}

class Batch : public ::testing::Test {
 protected:
  Batch() {
    fs::create_directories(folder_.path("parts/below"));
    for (const int side : {20, 30}) folder_.file("parts/" + std::to_string(side) + ".json", square(side));
    folder_.file("parts/below/40.json", square(40));
    folder_.file("parts/bad.json", "{\"outer\": 3}");
    folder_.file("parts/notes.txt", "no part");
  }

  CommandResult batch(std::vector<std::string> more = {}) const { return batch_into(out(), std::move(more)); }
  CommandResult batch_into(const std::string& output, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{
        "batch",     folder_.path("parts"), "--output", output,       "--tool",
        "endmill:6", "--strategy",          "zigzag",   "--stepdown", "0.04in"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_clearcut(arguments);
  }
  std::string out() const { return folder_.path("out"); }
  std::string text(const std::string& name) const { return read_file(out() + "/" + name); }

  ScratchFolder folder_;
};

TEST_F(Batch, OneBadPartStopsNoOther) {
  const CommandResult result = batch();
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_THAT(result.out, HasSubstr("3 of 4 CLEAN, 1 UNUSABLE\n"));
  const auto rows = nlohmann::json::parse(text("results.json"));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].at("name"), "20.json");
  EXPECT_EQ(rows[2].at("name"), "bad.json");
  EXPECT_EQ(rows[2].at("verdict"), "UNUSABLE");
  EXPECT_THAT(rows[2].at("message"), HasSubstr("bad.json"));
  EXPECT_EQ(rows[3].at("name"), "below/40.json");
  EXPECT_GT(rows[3].at("time_s"), rows[0].at("time_s"));
  EXPECT_TRUE(fs::exists(out() + "/below/40.json.ngc"));
  EXPECT_FALSE(fs::exists(out() + "/bad.json.ngc"));
  EXPECT_THAT(text("index.html"), HasSubstr("<img src=\"below/40.json.svg\""));
  EXPECT_THAT(text("results.csv"), HasSubstr("\n20.json,"));
}

/// The share of each program's certificate adds up in the order of the rows.
TEST_F(Batch, SaysWhichProgramEndsTheCutter) {
  const auto worn_by = [this](const std::string& spindle) {
    return batch({"--material", "steel", "--feed", "300", "--spindle", spindle});
  };
  EXPECT_THAT(worn_by("4000").out, HasSubstr("of a cutter's life, no program uses it up"));
  const auto wear_in = [](const nlohmann::json& row) { return row.at("tool_wear").at("1").get<double>(); };
  auto rows = nlohmann::json::parse(text("results.json"));
  EXPECT_DOUBLE_EQ(wear_in(rows[1]),
                   nlohmann::json::parse(text("30.json.json")).at("load").at("tool_wear").get<double>());
  const auto fast = worn_by("60000");
  rows = nlohmann::json::parse(text("results.json"));
  double used = 0;
  std::string ends;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].contains("tool_wear")) continue;
    used += wear_in(rows[i]);
    if (used < 1) continue;
    used = 0;
    ends += (ends.empty() ? "" : ", ") + rows[i].at("name").get<std::string>() + " (no. " +
            std::to_string(i + 1) + ")";
  }
  ASSERT_NE(ends, "") << "the trial needs a speed at which a cutter does not last";
  EXPECT_THAT(fast.out, HasSubstr("used up in " + ends));
}

TEST_F(Batch, ProgramsAreThoseOfPlan) {
  batch();
  const std::string alone = folder_.path("alone.ngc");
  run_clearcut({"plan", folder_.path("parts/30.json"), "--output", alone, "--tool", "endmill:6", "--strategy",
                "zigzag", "--stepdown", "0.04in", "--quiet"});
  EXPECT_EQ(text("30.json.ngc"), read_file(alone));
}

TEST_F(Batch, RunAgainDoesWhatChangedAndNothingElse) {
  batch();
  const std::string before = text("results.csv");
  EXPECT_THAT(batch().out, HasSubstr("(4 as they were)"));
  EXPECT_EQ(text("results.csv"), before);
  folder_.file("parts/20.json", square(25));
  EXPECT_THAT(batch().out, HasSubstr("(3 as they were)"));
  EXPECT_NE(text("results.csv"), before);
  fs::remove(out() + "/30.json.ngc");  // lost: planned anew
  EXPECT_THAT(batch().out, HasSubstr("(3 as they were)"));
  EXPECT_THAT(batch({"--feed", "500"}).out, Not(HasSubstr("as they were")));
}

TEST_F(Batch, ResultsBelowThePartsAreNoParts) {
  const std::string below = folder_.path("parts/out");
  EXPECT_THAT(batch_into(below).out, HasSubstr("3 of 4 CLEAN"));
  EXPECT_THAT(batch_into(below).out, HasSubstr("3 of 4 CLEAN, 1 UNUSABLE (4 as they were)"));
  EXPECT_EQ(batch_into(folder_.path("parts")).exit_code, 2);
}

TEST_F(Batch, FilesThatAJobNamesCount) {
  folder_.file("parts/job.toml", "[part]\nfile = \"20.json\"\n");
  const std::vector<std::string> words{
      "batch", folder_.file("list.txt", "parts/job.toml\n"), "--output", out(), "--tool", "endmill:6"};
  EXPECT_THAT(run_clearcut(words).out, HasSubstr("1 of 1 CLEAN"));
  EXPECT_THAT(run_clearcut(words).out, HasSubstr("(1 as they were)"));
  folder_.file("parts/20.json", square(26));
  EXPECT_THAT(run_clearcut(words).out, Not(HasSubstr("as they were")));
}

TEST_F(Batch, SharesMakeTheWhole) {
  batch();
  const std::string whole = text("results.csv");
  fs::remove_all(out());
  batch({"--share", "2/2"});
  EXPECT_FALSE(fs::exists(out() + "/results.csv"));
  batch({"--share", "1/2"});
  EXPECT_THAT(batch().out, HasSubstr("(4 as they were)"));
  EXPECT_EQ(text("results.csv"), whole);
}

TEST_F(Batch, WhatHangsOrCrashesIsOneRow) {
  folder_.file("list.txt",
               "# parts, each with options of its own\n"
               "parts/20.json\n"
               "parts/20.json --stepdown 0.0005 --strategy adaptive  # thousands of layers\n");
  const std::vector<std::string> base{"batch",    folder_.path("list.txt"), "--output", out(), "--tool",
                                      "endmill:2"};
  auto timed = base;
  timed.insert(timed.end(), {"--part-time", "1"});
  EXPECT_THAT(run_clearcut(timed).out, HasSubstr("1 of 2 CLEAN, 1 TIMED OUT"));
  auto starved = base;
  starved.insert(starved.end(), {"--part-memory", "8", "--again"});
  EXPECT_THAT(run_clearcut(starved).out, HasSubstr("0 of 2 CLEAN, 2 CRASHED"));
}

TEST_F(Batch, WrongQuestionsAreRefusedAtOnce) {
  EXPECT_EQ(batch({"--share", "3/2"}).exit_code, 2);
  EXPECT_EQ(batch({"--no-such-option"}).exit_code, 2);
  fs::create_directories(folder_.path("empty"));
  const CommandResult empty = run_clearcut({"batch", folder_.path("empty"), "--output", out()});
  EXPECT_EQ(empty.exit_code, 2);
  EXPECT_THAT(empty.err, HasSubstr("holds no parts"));
}

}  // namespace
}  // namespace clearcut
