// The rows of faults and conditions: complete, in order, and named in the documents that list them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "model/results/findings.h"

namespace clearcut {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(std::string(CLEARCUT_SOURCE_DIR) + "/" + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(FaultRows, StandInTheOrderOfTheirKindsWithOneRankEach) {
  std::set<int> ranks;
  std::set<std::string> names;
  for (std::size_t i = 0; i < fault_rows().size(); ++i) {
    const FaultRow& row = fault_rows()[i];
    EXPECT_EQ(static_cast<std::size_t>(row.kind), i) << row.name << " stands at another place than its kind";
    EXPECT_TRUE(ranks.insert(row.rank).second) << row.name << " has the rank of another fault: " << row.rank;
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_GT(std::string(row.meaning).size(), 10U) << row.name;
  }
  EXPECT_EQ(*ranks.begin(), 1);
  EXPECT_EQ(*ranks.rbegin(), static_cast<int>(ranks.size()));
}

TEST(FaultRows, AreInTheSchemaOfCertificatesAndInTheDocumentOfReports) {
  const std::string schema = text_of("docs/certificate.schema.json"), report = text_of("docs/report.md");
  ASSERT_FALSE(schema.empty());
  for (const FaultRow& row : fault_rows()) {
    const std::string name = row.name;
    EXPECT_NE(schema.find("\"" + name + "\""), std::string::npos)
        << "docs/certificate.schema.json does not list the fault \"" << name
        << "\"; see docs/adding-a-fault.md";
    EXPECT_NE(report.find("`" + name + "`"), std::string::npos)
        << "docs/report.md does not list the fault `" << name << "`; see docs/adding-a-fault.md";
  }
}

TEST(ConditionRows, AreThoseOfTheDocument) {
  const std::string document = text_of("docs/conditions.md");
  for (const ConditionRow& row : condition_rows()) {
    const std::string name(row.example.empty() ? row.name : row.example);
    EXPECT_TRUE(is_condition(name)) << name;
    EXPECT_NE(document.find("`" + name + "`"), std::string::npos)
        << "docs/conditions.md does not explain the condition `" << name << "`; see docs/adding-a-fault.md";
  }
}

TEST(ConditionRows, NumbersStandForThemselves) {
  for (const char* name :
       {"g59.3", "g154-p12", "m130", "g30-home", "tool-length-h99", "tool-length-g43.1", "datum-1"})
    EXPECT_TRUE(is_condition(name)) << name;
  for (const char* name : {"", "g", "g54-p", "gg55", "blend", "blending ", "tool-length-h", "m6a", "g#"})
    EXPECT_FALSE(is_condition(name)) << name;
}

TEST(VerdictAndReasons, HundredsOfOneKindAreOneLine) {
  Findings findings;
  const auto lines = [&] {
    const std::string text = verdict_and_reasons(findings);
    return std::count(text.begin(), text.end(), '\n');
  };
  for (int i = 0; i < 8; ++i) {
    Fault fault;
    fault.kind = FaultKind::kUncut;
    fault.text = "Pocket " + std::to_string(i) + " is not cut.";
    findings.faults.push_back(fault);
  }
  EXPECT_EQ(lines(), 9);
  while (findings.faults.size() < 300) findings.faults.push_back(findings.faults.back());
  for (int i = 0; i < 200; ++i)
    findings.conditions.push_back({"out-of-reach", "Some is out of reach.", 0, ""});
  EXPECT_EQ(lines(), 3);
  EXPECT_THAT(verdict_and_reasons(findings),
              testing::HasSubstr("Pocket 0 is not cut. (299 more faults like it)\n"));
  EXPECT_THAT(verdict_and_reasons(findings), testing::HasSubstr("(199 more conditions like it)"));
}

}  // namespace
}  // namespace clearcut
