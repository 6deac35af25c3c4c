// Contour keeps the fastest of its own plan and those of published methods.
#include <gtest/gtest.h>

#include <string>

#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

Part star() {
  return drawn(outline("POCKET_D2", {{{0, 50}},
                                     {{-14.434, 25}},
                                     {{-43.301, 25}},
                                     {{-28.868, 0}},
                                     {{-43.301, -25}},
                                     {{-14.434, -25}},
                                     {{0, -50}},
                                     {{14.434, -25}},
                                     {{43.301, -25}},
                                     {{28.868, 0}},
                                     {{43.301, 25}},
                                     {{14.434, 25}}}));
}

double seconds_of(const std::string& strategy) {
  PlanOptions options = with({"endmill:6"});
  options.strategy = strategy;
  options.cutting.feed = MmPerMin::of(3000);
  options.post.dialect = "linuxcnc";
  return plan_part(star(), options).findings.all.time_s;
}

/// By the plain rule another method seems faster on this star, which takes LinuxCNC 4 % longer.
TEST(RivalPlan, IsKeptWhereThePlannerOfTheControlIsFaster) {
  EXPECT_LT(seconds_of("contour"), 1.01 * seconds_of("single"));
}

}  // namespace
}  // namespace clearcut::pipeline
