// A program has one verdict: that of its plan is that of reading it again as anybody's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "pipeline/check.h"
#include "pipeline/run.h"
#include "read/gcode/program/dialect.h"
#include "read/job/read_part.h"
#include "resolve/values/plan_options.h"
#include "support/random/first_seed.h"

namespace clearcut {
namespace {

/// Verdict and the names of faults and conditions, those that are met included.
std::string told(const Findings& findings) {
  std::vector<std::string> names;
  for (const Fault& fault : findings.faults) names.emplace_back(name_of(fault.kind));
  for (const Condition& one : findings.conditions) names.push_back(one.name);
  std::sort(names.begin(), names.end());
  std::string text = name_of(verdict_of(findings));
  for (const std::string& name : names) text += " " + name;
  return text;
}

/// One to three pockets beside each other.
std::string random_pockets(Random& random) {
  std::string text = R"({"units": "mm", "pockets": [)";
  double x = 0;
  const auto count = 1 + random.below(3);
  for (std::size_t i = 0; i < count; ++i) {
    const double w = 8 + 0.5 * static_cast<double>(random.below(30));
    const double h = 8 + 0.5 * static_cast<double>(random.below(24));
    const double depth = 0.5 + 0.25 * static_cast<double>(random.below(16));
    const auto at = [](double px, double py) {
      return "[" + std::to_string(px) + ", " + std::to_string(py) + "]";
    };
    text += (i ? ", " : "") + std::string(R"({"name": ")") + "ABC"[i] + R"(", "top": 0, "depth": )" +
            std::to_string(depth) + R"(, "outer": [)" + at(x, 0) + ", " + at(x + w, 0) + ", " + at(x + w, h) +
            ", " + at(x, h) + "]}";
    x += w + 5;
  }
  return text + "]}";
}

PlanOptions random_options(Random& random) {
  PlanOptions options;
  const char* const wide[] = {"endmill:6", "endmill:4", "endmill:8"};
  options.tools.push_back(resolve::parse_tool(wide[random.below(3)]));
  if (random.below(2) == 0) {
    options.tools.push_back(resolve::parse_tool("endmill:2"));
    options.shop.rest = true;
  }
  options.post.dialect = kControllers[random.below(std::size(kControllers))];
  options.post.length_offset = random.below(3) > 0;
  options.post.tool_changer = random.below(4) > 0;
  options.post.inch = random.below(5) == 0;
  options.post.exact_stop = random.below(5) == 0;
  if (random.below(3) == 0) options.stepdown = 1.5;
  if (random.below(3) == 0) options.entry = EntryKind::kRamp;
  if (random.below(4) == 0) options.shop.dogbones = "corner";
  if (random.below(4) == 0) options.shop.finish = "walls";
  if (random.below(4) == 0) options.allowance = 0.1;
  options.strategy = "contour";
  options.threads = 1;
  return options;
}

TEST(OneVerdict, OfPlanAndVerify) {
  Random random(static_cast<std::uint64_t>(19 + test_support::first_seed()));
  int compared = 0;
  const char* set = std::getenv("CLEARCUT_ONE_VERDICT");
  const int count = set ? std::atoi(set) : 40;
  for (int i = 0; i < count; ++i) {
    const std::string text = random_pockets(random);
    const PlanOptions options = random_options(random);
    const Part part = read::read_part_text(text, "part.json", {});
    PlanResult plan;
    try {
      plan = pipeline::plan_part(part, options);
    } catch (const InputError&) {
      continue;  // the control, or the part, has no use for an option
    }
    const auto dialect = read::gcode::dialect_named(options.post.dialect);
    const CheckResult check = pipeline::check_program(part, plan.program, "program", options, dialect);
    EXPECT_EQ(told(plan.findings), told(check.findings)) << options.post.dialect << "\n" << text;
    ++compared;
  }
  EXPECT_GT(compared, 30);
}

/// What finishing goes over has no stepdown that anybody stated, and leaning walls are finished in layers.
TEST(OneVerdict, OfFinishingLeaningWalls) {
  const std::string text =
      R"({"units": "mm", "pockets": [{"name": "B", "top": 0, "depth": 1.56, "slope_rad": 0.09,
      "outer": [[0, 0], [22, 0], [22, 14.6], [0, 14.6]]}]})";
  const Part part = read::read_part_text(text, "part.json", {});
  PlanOptions options;
  options.tools = {resolve::parse_tool("bullnose:4:corner=0.5"), resolve::parse_tool("ball:2")};
  options.shop.rest = true;
  options.shop.finish = "walls";
  options.strategy = "zigzag";
  const PlanResult plan = pipeline::plan_part(part, options);
  const CheckResult check =
      pipeline::check_program(part, plan.program, "program", options, Dialect::kLinuxCnc);
  EXPECT_EQ(told(plan.findings), told(check.findings)) << verdict_and_reasons(check.findings);
}

}  // namespace
}  // namespace clearcut
