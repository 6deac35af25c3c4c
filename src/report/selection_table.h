// What the strategies came to, feature by feature.
#pragma once

#include <vector>

#include "model/results/strategy_selection.h"
#include "report/words/text_table.h"

namespace clearcut::report {

/// One row a feature and strategy: time, feed length, what became of it. Times with ">" are bounds of what was not
/// planned because it cannot win.
TextTable selection_table(const std::vector<StrategySelection>& selections);

}  // namespace clearcut::report
