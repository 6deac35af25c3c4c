// Planning in tests: options with tools, and what a clean result is.
#pragma once

#include <string>
#include <vector>

#include "pipeline/run.h"

namespace clearcut::test_support {

/// Options with these tools, each written as on the command line.
PlanOptions plan_options_with(const std::vector<std::string>& tools);

/// Options with one end mill; diameter in mm.
PlanOptions with_tool(double diameter);

/// Clean by its own certificate, in every figure that makes it so, and not for want of a cut.
void expect_clean(const PlanResult& result, const std::string& what);

}  // namespace clearcut::test_support
