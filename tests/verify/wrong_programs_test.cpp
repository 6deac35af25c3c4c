// The folder of wrong programs, each with what a controller does with it, and their right twins: the verdict on every one.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "pipeline/check.h"
#include "pipeline/job_options.h"
#include "read/common/data_value.h"
#include "read/job/machine_file.h"
#include "read/job/read_part.h"
#include "read/tools/tool_library.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;

fs::path folder() {
  return fs::path(CLEARCUT_BINARY_DIR) / "tests/wrong_programs";
}

struct VerdictFound {
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

/// The tools and what is asked of them: a library goes before what the case names.
PlanOptions options_of(const read::DataValue& one) {
  PlanOptions options;
  const fs::path parts = folder() / "parts";
  if (const read::DataValue* library = one.find("library")) {
    const ToolLibrary read = read::read_tool_library(parts / library->text, {});
    for (const LibraryTool& entry : read.tools) options.tools.push_back(entry.tool);
    options.tool_cutting = pipeline::cutting_of_tools(read.tools, "");
  } else {
    for (const std::string& tool : texts_of(*one.find("tools")))
      options.tools.push_back(resolve::parse_tool(tool));
  }
  if (const read::DataValue* machine = one.find("machine"))
    options.machine = read::read_machine(parts / machine->text);
  if (const read::DataValue* engagement = one.find("engagement")) options.engagement_deg = engagement->number;
  if (const read::DataValue* stepdown = one.find("stepdown")) options.stepdown = stepdown->number;
  if (const read::DataValue* side = one.find("allowance")) options.allowance = side->number;
  if (const read::DataValue* floor = one.find("allowance_floor")) options.allowance_floor = floor->number;
  if (const read::DataValue* scallop = one.find("scallop")) options.scallop = scallop->number;
  if (const read::DataValue* clamps = one.find("keep_out")) {
    for (const std::string& clamp : texts_of(*clamps))
      options.keep_outs.push_back(resolve::parse_keep_out(clamp));
  }
  return options;
}

/// Against the part that the case names, or alone.
CheckResult checked(const read::DataValue& one, const fs::path& file, const PlanOptions& options) {
  const std::string program = read_file(file.string()), name = file.filename().string();
  const auto dialect = read::gcode::dialect_named(one.find("dialect")->text);
  const std::string part = one.find("part")->text;
  if (!part.empty())
    return pipeline::check_program(read::read_part(folder() / "parts" / part, {}), program, name, options,
                                   dialect);
  std::optional<Stock> stock;
  if (const read::DataValue* stated = one.find("stock")) stock = resolve::parse_stock(stated->text);
  return pipeline::check_program_alone(stock, program, name, options, dialect);
}

/// No feature that a fault names counts as clean.
void expect_no_faulty_one_clean(const Findings& findings) {
  for (const FeatureFindings& feature : findings.features) {
    for (const Fault& fault : findings.faults)
      EXPECT_FALSE(feature.figures.clean && fault.feature == feature.name) << fault.text;
  }
}

VerdictFound verdict_on(const read::DataValue& one, const fs::path& place) {
  PlanOptions options = options_of(one);
  const fs::path file = place / one.find("file")->text;
  options.accept = texts_of(*one.find("accept"));
  CheckResult result;
  try {
    result = checked(one, file, options);
  } catch (const InputError& error) {
    return {"REFUSED", {error.what()}};
  }
  expect_no_faulty_one_clean(result.findings);
  VerdictFound verdict{name_of(verdict_of(result.findings)), {}};
  for (const Fault& fault : result.findings.faults) verdict.reasons.insert(dashed(name_of(fault.kind)));
  if (!verdict.reasons.empty()) return verdict;
  for (const Condition& condition : open_conditions(result.findings)) verdict.reasons.insert(condition.name);
  return verdict;
}

class WrongPrograms : public ::testing::TestWithParam<std::string> {};

TEST_P(WrongPrograms, GetTheVerdictTheyDeserve) {
  const fs::path place = folder() / GetParam();
  const std::string list = (place / "cases.json").string();
  const read::DataValue cases = read::parse_json(read_file(list), list);
  ASSERT_GT(cases.items.size(), 10U);
  for (const read::DataValue& one : cases.items) {
    const std::string file = one.find("file")->text, wanted = one.find("verdict")->text,
                      reason = one.find("reason")->text;
    SCOPED_TRACE(GetParam() + "/" + file + ": " + one.find("does")->text);
    const VerdictFound found = verdict_on(one, place);
    std::string reasons;
    for (const std::string& name : found.reasons) reasons += " " + name;
    const bool met = found.name == wanted && (reason.empty() || found.reasons.count(reason) > 0);
    EXPECT_TRUE(met) << "wanted " << wanted << " " << reason << ", found " << found.name << reasons;
  }
}

INSTANTIATE_TEST_SUITE_P(Classes, WrongPrograms,
                         ::testing::Values("motion", "comments", "dialects", "conditions", "state",
                                           "blending", "small", "cycles", "limits", "worst", "holes", "alone",
                                           "habits", "holder", "cutters", "leaves", "entries", "takes",
                                           "taps", "sinumerik", "okuma"),
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
  for (const std::string& name : controller_names()) EXPECT_TRUE(dialects.count(name) > 0) << name;
}

}  // namespace
}  // namespace clearcut
