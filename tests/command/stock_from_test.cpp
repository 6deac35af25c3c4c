// What the work begins with, as a user names it: a solid, or the program that has run before.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/file.h"
#include "read/step_solid/solid_model.h"
#include "support/command.h"

namespace clearcut {
namespace {

using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::HasSubstr;

const std::string kExamples = CLEARCUT_SOURCE_DIR "/examples/";

/// The bracket's pocket of 5 mm is there already; the drawing wants it 8 mm deep.
TEST(StockFrom, ASolidsPocketsAreNotCutAgain) {
  if (!read::solids_can_be_read()) GTEST_SKIP() << "built without Open CASCADE";
  const ScratchFolder folder;
  const auto plan = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"plan",
                                   kExamples + "bracket.dxf",
                                   "--depth",
                                   "8",
                                   "--tool",
                                   "endmill:6",
                                   "-o",
                                   folder.path("out.ngc"),
                                   "--certificate",
                                   folder.path("out.json"),
                                   "--stepdown",
                                   "2.5"};
    words.insert(words.end(), more.begin(), more.end());
    const auto run = run_clearcut(words);
    EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
    return nlohmann::json::parse(read_file(folder.path("out.json")));
  };
  const auto all = plan({}), rest = plan({"--stock-from", kExamples + "bracket.step"});
  const auto feed = [](const nlohmann::json& certificate) { return certificate.at("feed_mm").get<double>(); };
  EXPECT_LT(feed(rest), 0.6 * feed(all));
  bool named = false;
  for (const auto& file : rest.at("inputs")) named |= file.at("role") == "stock";
  EXPECT_TRUE(named);
  const auto verified =
      run_clearcut({"verify", folder.path("out.ngc"), "--part", kExamples + "bracket.dxf", "--depth", "8",
                    "--tool", "endmill:6", "--stock-from", kExamples + "bracket.step"});
  EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
}

TEST(StockFrom, ASolidThatLacksWhatThePartHasIsAFault) {
  if (!read::solids_can_be_read()) GTEST_SKIP() << "built without Open CASCADE";
  const ScratchFolder folder;
  const auto run = run_clearcut({"plan", kExamples + "bracket.dxf", "--depth", "4", "--tool", "endmill:6",
                                 "-o", folder.path("out.ngc"), "--stock-from", kExamples + "bracket.step"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.out, HasSubstr("in the stock, which lacks material of the part"));
}

TEST(StockFrom, AProgramIsWhatRanBefore) {
  const ScratchFolder folder;
  const std::vector<std::string> common{"plan",    kExamples + "bracket.dxf", "--depth", "5", "--post",
                                        "linuxcnc"};
  const auto plan = [&](std::vector<std::string> more) {
    std::vector<std::string> words = common;
    words.insert(words.end(), more.begin(), more.end());
    const auto run = run_clearcut(words);
    EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  };
  plan({"--tool", "endmill:12:T1", "-o", folder.path("first.ngc"), "--accept", "out-of-reach"});
  const std::vector<std::string> tools{"--tool", "endmill:12:T1", "--tool", "endmill:3:T2"};
  for (const char* option : {"--after", "--stock-from"}) {
    std::vector<std::string> more = tools;
    more.insert(more.end(), {option, folder.path("first.ngc"), "-o",
                             folder.path(std::string(option).substr(2) + ".ngc")});
    plan(more);
  }
  EXPECT_EQ(read_file(folder.path("after.ngc")), read_file(folder.path("stock-from.ngc")));
}

/// What ran before is right or it is not: its conditions and its faults are those of what rests on it.
TEST(StockFrom, AProgramBeforeHasConditionsAndFaults) {
  const ScratchFolder folder;
  const std::vector<std::string> part{kExamples + "bracket.dxf", "--depth", "5"};
  const auto run = [&](std::vector<std::string> words, std::vector<std::string> more) {
    words.insert(words.end(), part.begin(), part.end());
    words.insert(words.end(), more.begin(), more.end());
    return run_clearcut(words);
  };
  ASSERT_EQ(
      run({"plan"}, {"--tool", "endmill:12:T1", "-o", folder.path("first.ngc"), "--accept", "out-of-reach"})
          .exit_code,
      0);
  const std::vector<std::string> tools{"--tool", "endmill:12:T1", "--tool", "endmill:3:T2", "--quiet"};
  const std::string first = read_file(folder.path("first.ngc"));
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = first;
    text.replace(text.find(from), from.size(), to);
    return folder.file("changed.ngc", text);
  };
  const auto planned = [&](const std::string& before) {
    std::vector<std::string> more = tools;
    more.insert(more.end(), {"--after", before, "-o", folder.path("rest.ngc")});
    return run({"plan"}, more);
  };
  EXPECT_EQ(planned(folder.path("first.ngc")).out, "CLEAN\n");
  std::vector<std::string> again = tools;
  again.insert(again.end(), {"--part"});
  again.insert(again.end(), part.begin(), part.end());
  again.insert(again.end(), {"--after", folder.path("first.ngc"), "--dialect", "linuxcnc"});
  again.insert(again.begin(), {"verify", folder.path("rest.ngc")});
  EXPECT_EQ(run_clearcut(again).out, "CLEAN\n") << "the same verdict";
  EXPECT_THAT(planned(changed("G54", "G55")).out, HasSubstr("condition g55: in "));
  EXPECT_THAT(planned(changed("G80", "G92 X5")).out, HasSubstr("condition g92: in "));
  EXPECT_THAT(planned(changed("M3 S", "/M3 S")).out, HasSubstr("condition block-delete: in "));
  const auto stood = planned(changed("\nM2\n", "\nM3 S100\nM2\n"));
  EXPECT_EQ(stood.out, "CLEAN\n");
  const std::size_t at = first.find("M3 S");
  std::string off = first;
  off.erase(at, first.find('\n', at) - at);
  off.replace(off.find("M5"), 2, "M3 S100\nM5");
  const auto faulty = planned(folder.file("off.ngc", off));
  EXPECT_EQ(faulty.exit_code, 1);
  EXPECT_THAT(faulty.out, HasSubstr("spindle off: in the program before: The spindle stands"));
}

TEST(StockFrom, WhatContradictsItselfIsRefused) {
  const ScratchFolder folder;
  const auto refusal = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"plan", kExamples + "bracket.dxf", "--depth", "5", "--tool", "endmill:6"};
    words.insert(words.end(), more.begin(), more.end());
    const auto run = run_clearcut(words);
    EXPECT_EQ(run.exit_code, 2);
    return run.err;
  };
  const std::string program = folder.file("a.ngc", "G21 G90\nG0 X0 Y0 Z5\nM2\n");
  EXPECT_THAT(refusal({"--after", program, "--stock-from", program}), HasSubstr("leave one of them out"));
  if (!read::solids_can_be_read()) return;
  EXPECT_THAT(refusal({"--stock-from", kExamples + "missing.step"}), HasSubstr("missing.step"));
  const std::string job =
      folder.file("job.toml", "[part]\nfile = \"" + kExamples +
                                  "bracket.dxf\"\ndepth = 5\n[stock]\nx = [0, 9]\ny = [0, 9]\nz = [-9, 0]\n"
                                  "[[tool]]\nkind = \"endmill\"\ndiameter = 6\n");
  const auto run = run_clearcut({"plan", job, "--stock-from", kExamples + "bracket.step"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("[stock] states a block"));
}

}  // namespace
}  // namespace clearcut
