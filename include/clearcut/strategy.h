// Strategies of one's own: from a layer to passes, which are ordered, linked and certified like those of the software.
//
//     std::vector<StrategyEntry> entries = built_in_strategies().entries();
//     entries.push_back(mine);  // name, and `make`: what gives the function from Layer to LayerPasses
//     const StrategyTable table(std::move(entries));
//     options.strategies = &table;
#pragma once

#include "clearcut/plan.h"
#include "model/clearing_area.h"
#include "model/options/strategy_entry.h"

namespace clearcut {

/// Splits a layer into wall passes and rest.
ClearingArea clearing_area(const Layer& layer, const Tolerances& tol);

/// Whether the layer is a pocket closed all round. The target is inside `allowed`, so the two are compared by area.
bool closed_all_round(const Layer& layer);

/// A strategy that plans each outline once: a layer that differs from the previous one only in height gets the same
/// passes at its own depth.
Strategy once_per_outline(Strategy plan);

}  // namespace clearcut
