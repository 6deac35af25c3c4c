// The entry of this strategy in the table of strategies.
#pragma once

#include "model/options/strategy_entry.h"

namespace clearcut::plan::zigzag {

StrategyEntry entry();

}  // namespace clearcut::plan::zigzag
