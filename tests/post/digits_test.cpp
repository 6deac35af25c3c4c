// Walls and floors of programs for controls with few digits: as near to the part as these digits can say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "model/part.h"
#include "pipeline/run.h"
#include "read/job/read_part.h"
#include "resolve/values/plan_options.h"

namespace clearcut {
namespace {

/// mm; of a 20 mm square pocket, 2 mm deep, cut by 6 mm.
struct Reach {
  double least_x = HUGE_VAL, deepest = HUGE_VAL;
};

Reach reach_of(const std::string& dialect) {
  const auto file = std::filesystem::path(CLEARCUT_BINARY_DIR) / "tests/wrong_programs/parts/pocket.json";
  PlanOptions options;
  options.tools.push_back(resolve::parse_tool("endmill:6"));
  options.post.dialect = dialect;
  const PlanResult planned = pipeline::plan_part(read::read_part(file, {}), options);
  EXPECT_TRUE(planned.findings.all.clean) << dialect;
  Reach reach;
  for (const Section& section : planned.toolpath.sections) {
    for (const Move& move : section.moves) {
      reach.least_x = std::min({reach.least_x, move.path.from.x, move.path.to.x});
      reach.deepest = std::min(reach.deepest, move.z_to);
    }
  }
  return reach;
}

TEST(Digits, OfMillimetresKeepWallsWithinAMicrometreAndFloorsExact) {
  for (const std::string& dialect : controller_names()) {
    SCOPED_TRACE(dialect);
    const Reach reach = reach_of(dialect);
    EXPECT_GE(reach.least_x, 3 - 1e-9);
    EXPECT_LE(reach.least_x, 3.001 + 1e-9);
    EXPECT_NEAR(reach.deepest, -2, 1e-9);
  }
}

}  // namespace
}  // namespace clearcut
