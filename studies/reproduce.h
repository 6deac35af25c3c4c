// The published tables: printed, ours, difference.
#pragma once

#include <string>
#include <vector>

#include "report/text_table.h"

namespace clearcut::studies {

/// Names that reproduce() takes.
const std::vector<std::string>& reproducible_tables();

/// One published table beside our figures; differences are marked. Throws InputError for an unknown name.
report::TextTable reproduce(const std::string& name);

}  // namespace clearcut::studies
