// Results of the strategies, feature by feature.
#pragma once

#include <vector>

#include "model/results/strategy_selection.h"
#include "report/words/text_table.h"

namespace clearcut::report {

/// One row for each feature and strategy: time, feed length, outcome. Times with ">" are lower bounds of strategies
/// not planned because they cannot win.
TextTable selection_table(const std::vector<StrategySelection>& selections);

}  // namespace clearcut::report
