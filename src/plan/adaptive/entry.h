// The entry of this strategy in the table of strategies.
#pragma once

#include "model/options/strategy_entry.h"
#include "plan/common/machine_clock.h"

namespace clearcut::plan::adaptive {

/// `clock_of`: how long moves take on the machine that a workingstep is for.
StrategyEntry entry(ClockOf clock_of);

}  // namespace clearcut::plan::adaptive
