// The check of programs as a function of texts.
#include "pipeline/check_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "options/row.h"

namespace clearcut::pipeline {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

Json checked(const std::string& program, const std::string& question) {
  return Json::parse(check_text(program, question));
}

std::string error(const std::string& program, const std::string& question) {
  return checked(program, question).value("error", "");
}

/// A slot along X at the depth, mm.
std::string slot(double depth) {
  return "G21 G90 G94\nT1 M6\nS10000 M3\nG0 Z5\nG0 X10 Y10\nG1 Z-" + std::to_string(depth) +
         " F100\nG1 X40 F300\nG0 Z5\nM5\nM30\n";
}

const char* const kPocket =
    R"({"name": "p.nc", "tools": ["endmill:6:T1"], "dialect": "linuxcnc",
        "part": {"outer": [[0, 0], [20, 0], [20, 20], [0, 20]], "depth": 2}})";

TEST(CheckText, AProgramAlone) {
  const Json answer =
      checked(slot(1), R"({"tools": ["endmill:6:T1"], "stock": "50,20,10", "dialect": "linuxcnc"})");
  EXPECT_EQ(answer.value("error", ""), "");
  EXPECT_TRUE(answer.contains("verdict")) << answer.dump(1);
  EXPECT_TRUE(answer["faults"].empty()) << answer["faults"].dump(1);
}

TEST(CheckText, ARapidThroughMaterialIsFaulty) {
  std::string program = slot(1);
  program.replace(program.find("G0 Z5\nM5"), 5, "G0 Z-1 X10 Y15");
  const Json answer =
      checked(program, R"({"tools": ["endmill:6:T1"], "stock": "50,20,10", "dialect": "linuxcnc"})");
  EXPECT_EQ(answer.value("verdict", ""), "FAULTY") << answer.dump(1);
}

TEST(CheckText, WhatIsLeftOfAPartIsFound) {
  const Json answer = checked(slot(1), kPocket);
  EXPECT_EQ(answer.value("verdict", ""), "FAULTY") << answer.dump(1);
}

TEST(CheckText, BadQuestionsAreOneLine) {
  EXPECT_THAT(error(slot(1), "{"), HasSubstr("question:1"));
  EXPECT_THAT(error(slot(1), R"({"tols": []})"), HasSubstr("tols"));
  EXPECT_THAT(error(slot(1), "{\n\"options\": {\"max-feeed\": 3}}"),
              HasSubstr("question:2: max-feeed: is no option"));
  EXPECT_THAT(error(slot(1), R"({"dialect": "fanux"})"), HasSubstr("fanux"));
  EXPECT_THAT(error(slot(1), R"({"tools": ["endmill"]})"), HasSubstr("endmill"));
  EXPECT_THAT(error(slot(1), "{\"part\": {\"outer\":\n[[0, 0], [\"a\", 0], [20, 20]], \"depth\": 2}}"),
              HasSubstr("question:2"));
  EXPECT_THAT(error(slot(1), R"({"tools": ["endmill:6"], "options": {"allowance": 0.2}})"),
              HasSubstr("needs a part"));
  EXPECT_THAT(error(slot(1), R"({"tools": ["endmill:6"], "options": {"dogbones": "corner"}})"),
              HasSubstr("dogbones: needs a part"));
  EXPECT_THAT(error(slot(1), R"({"tools": ["endmill:6"], "options": {"tools": "x.tbl"}})"),
              HasSubstr("tools"));
  EXPECT_THAT(error(slot(1), R"({"tools": ["endmill:6"], "machine": "no machine"})"),
              HasSubstr("no machine"));
}

TEST(CheckText, TheTopOfTheMaterialIsAKeyOrAnOption) {
  const auto faults = [](const std::string& top) {
    return checked(slot(1), R"({"tools": ["endmill:6:T1"], "stock": "50,20,10", "dialect": "linuxcnc", )" +
                                top + "}")["faults"];
  };
  EXPECT_EQ(faults(R"("top": 8)"), faults(R"("options": {"top": 8})"));
  EXPECT_NE(faults(R"("top": 8)"), faults(R"("top": 0)"));
}

TEST(CheckText, BadProgramsAreOneLineWithTheirName) {
  EXPECT_THAT(error("G1 X[ F100\n", R"({"name": "a.nc", "tools": ["endmill:6"], "dialect": "linuxcnc"})"),
              HasSubstr("a.nc:1"));
  EXPECT_NE(error("", R"({"tools": ["endmill:6"]})"), "");
}

TEST(CheckText, TheMachineLimitsAreKept) {
  const char* const kWithLimit =
      R"({"tools": ["endmill:6:T1"], "stock": "50,20,10", "dialect": "linuxcnc", "machine": {"max_feed": 200}})";
  EXPECT_NE(checked(slot(1), kWithLimit)["faults"].dump(), "[]");
}

TEST(CheckText, NoOptionNamesAFile) {
  EXPECT_GT(question_options().size(), 20u);
  for (const std::string& name : question_options()) {
    const Row* const row = row_named(name);
    ASSERT_NE(row, nullptr) << name;
    EXPECT_TRUE(row->kind != ValueKind::kFile && row->kind != ValueKind::kFiles) << name;
  }
}

}  // namespace
}  // namespace clearcut::pipeline
