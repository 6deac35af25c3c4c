// The strategy that docs/adding-a-strategy.md adds.
#pragma once

#include "model/options/strategy_entry.h"

namespace clearcut::test_support::rings {

/// Contours at half the cutter's radius from one another, from the walls to the middle of closed pockets.
StrategyEntry entry();

}  // namespace clearcut::test_support::rings
