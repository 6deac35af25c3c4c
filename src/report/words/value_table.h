// The values of a plan and their sources.
#pragma once

#include <vector>

#include "model/options/resolved_plan.h"
#include "report/words/text_table.h"

namespace clearcut::report {

/// One row for each value of a name, with the numbers of the workingsteps sharing it; then the values of the whole
/// plan.
TextTable value_table(const Part& part, const std::vector<ResolvedValue>& values);

}  // namespace clearcut::report
