// What a plan was made with, and where each value comes from.
#pragma once

#include <vector>

#include "model/options/resolved_plan.h"
#include "report/words/text_table.h"

namespace clearcut::report {

/// One row for each value of a name, with the numbers of the workingsteps that share it; then those of the whole plan.
TextTable value_table(const Part& part, const std::vector<ResolvedValue>& values);

}  // namespace clearcut::report
