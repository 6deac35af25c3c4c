// Strategies of one's own: from a layer to passes, which are ordered, linked and certified like those of the software.
//
//     std::vector<StrategyEntry> entries = built_in_strategies().entries();
//     entries.push_back(mine);  // name, and `make`: what gives the function from Layer to LayerPasses
//     const StrategyTable table(std::move(entries));
//     options.strategies = &table;
#pragma once

#include "model/layer.h"
#include "model/options/strategy_entry.h"
#include "plan/common/clearing_area.h"
#include "plan/common/layers.h"

namespace clearcut {

using plan::clearing_area;
using plan::ClearingArea;
using plan::ClearingComponent;
using plan::closed_all_round;
using plan::once_per_outline;

}  // namespace clearcut
