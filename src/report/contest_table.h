// What the strategies came to, feature by feature.
#pragma once

#include <vector>

#include "model/results/contest.h"
#include "report/text_table.h"

namespace clearcut::report {

/// One row a feature and strategy: time, feed length, what became of it. Times with ">" are bounds of what was not
/// planned because it cannot win.
TextTable contest_table(const std::vector<Contest>& contests);

}  // namespace clearcut::report
