// The entry of this strategy in the table of strategies.
#pragma once

#include "model/options/strategy_entry.h"

namespace clearcut::plan::adaptive {

StrategyEntry entry();

}  // namespace clearcut::plan::adaptive
