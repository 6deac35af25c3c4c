// The folder of wrong programs, each with what a controller does with it, and their right twins: the verdict on every one.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "pipeline/run.h"
#include "read/common/data_value.h"
#include "read/read_part.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;

/// Reasons that nothing judges yet: cases that fail for them are counted, and must not be met by accident.
const std::set<std::string> kNotJudgedYet{"tool-length", "spindle-off", "spindle-direction"};
/// Cases by their file whose reason is judged in general, but not as finely as they need.
const std::set<std::string> kNotMetYet{"blending/wide", "state/steep"};

fs::path folder() {
  return fs::path(CLEARCUT_SOURCE_DIR) / "tests/wrong_programs";
}

struct Verdict {
  std::string name;  ///< CLEAN, CONDITIONAL, FAULTY, REFUSED
  std::set<std::string> reasons;
};

std::string dashed(std::string text) {
  std::replace(text.begin(), text.end(), ' ', '-');
  return text;
}

std::vector<std::string> texts_of(const read::DataValue& list) {
  std::vector<std::string> texts;
  for (const read::DataValue& item : list.items) texts.push_back(item.text);
  return texts;
}

Verdict verdict_on(const read::DataValue& one, const fs::path& place) {
  resolve::PlanOptions options;
  for (const std::string& tool : texts_of(*one.find("tools")))
    options.tools.push_back(resolve::parse_tool(tool));
  const Part part = read::read_part(folder() / "parts" / one.find("part")->text, {});
  const fs::path file = place / one.find("file")->text;
  Verdict verdict;
  pipeline::CheckResult result;
  try {
    result = pipeline::check_program(part, read_file(file.string()), file.filename().string(), options,
                                     read::gcode::dialect_named(one.find("dialect")->text));
  } catch (const InputError& error) {
    return {"REFUSED", {error.what()}};
  }
  for (const Fault& fault : result.findings.faults) verdict.reasons.insert(dashed(name_of(fault.kind)));
  if (!verdict.reasons.empty()) {
    verdict.name = "FAULTY";
    return verdict;
  }
  const std::vector<std::string> accepted = texts_of(*one.find("accept"));
  for (const Condition& condition : result.conditions) {
    if (std::find(accepted.begin(), accepted.end(), condition.name) == accepted.end())
      verdict.reasons.insert(condition.name);
  }
  verdict.name = verdict.reasons.empty() ? "CLEAN" : "CONDITIONAL";
  return verdict;
}

class WrongPrograms : public ::testing::TestWithParam<std::string> {};

TEST_P(WrongPrograms, GetTheVerdictTheyDeserve) {
  const fs::path place = folder() / GetParam();
  const std::string list = (place / "cases.json").string();
  const read::DataValue cases = read::parse_json(read_file(list), list);
  ASSERT_GT(cases.items.size(), 10U);
  int unmet = 0;
  for (const read::DataValue& one : cases.items) {
    const std::string file = one.find("file")->text, wanted = one.find("verdict")->text,
                      reason = one.find("reason")->text;
    SCOPED_TRACE(GetParam() + "/" + file + ": " + one.find("does")->text);
    const Verdict found = verdict_on(one, place);
    std::string reasons;
    for (const std::string& name : found.reasons) reasons += " " + name;
    const bool met = found.name == wanted && (reason.empty() || found.reasons.count(reason) > 0);
    const std::string stem = GetParam() + "/" + file.substr(0, file.rfind('-'));
    if (kNotJudgedYet.count(reason) > 0 || kNotMetYet.count(stem) > 0) {
      unmet += met ? 0 : 1;
      if (!met) std::printf("%s: %s%s\n", file.c_str(), found.name.c_str(), reasons.c_str());
    } else {
      EXPECT_TRUE(met) << "wanted " << wanted << " " << reason << ", found " << found.name << reasons;
    }
  }
  RecordProperty("unmet", unmet);
  if (unmet > 0) std::printf("%d of %zu cases wait for what judges them\n", unmet, cases.items.size());
}

INSTANTIATE_TEST_SUITE_P(Classes, WrongPrograms,
                         ::testing::Values("motion", "comments", "dialects", "conditions", "state",
                                           "blending", "small"),
                         [](const auto& one) { return one.param; });

/// Every right program that states its dialect is taken, and each class has right twins or accepted ones.
TEST(WrongPrograms, CoverEveryDialect) {
  std::set<std::string> dialects;
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(folder())) {
    if (!fs::exists(entry.path() / "cases.json")) continue;
    const std::string list = (entry.path() / "cases.json").string();
    const read::DataValue cases = read::parse_json(read_file(list), list);
    count += cases.items.size();
    for (const read::DataValue& one : cases.items) dialects.insert(one.find("dialect")->text);
  }
  EXPECT_GT(count, 150U);
  for (const char* name : {"linuxcnc", "grbl", "fanuc", "haas", "heidenhain", "mach3", "mach4", "marlin"}) {
    EXPECT_TRUE(dialects.count(name) > 0) << name;
  }
}

}  // namespace
}  // namespace clearcut
