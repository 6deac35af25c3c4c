// What a program says by its own moves, where nobody has stated a part: the stock it may be for, and what is open with it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/control.h"
#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"

namespace clearcut::pipeline {

/// The box of what feed moves sweep below `top`, mm; nothing if none goes below. Tools that are not among `tools` count by their
/// centres.
std::optional<Stock> box_of_cuts(const Toolpath& toolpath, const std::vector<Tool>& tools, double top);

/// The highest move along which the tool works above `top`, mm: a feed move across at a height to which the tool was fed down, or went
/// down to at the rapid from where it crosses. Ways across at the feed, from where the tool rose to that height, are none. Null: nothing
/// works up there.
const Move* work_above(const Toolpath& toolpath, double top);

/// That this box was taken for the stock.
Condition stock_taken(const Stock& stock);

/// That what the stock lies on may be cut as deep as the program feeds below it; nothing if it does not.
std::optional<Condition> below_stock(const Toolpath& toolpath, const Stock& stock);

/// That arcs whose words give two radii run as they were read; nothing if no two differ by more than `tol.uncut`.
std::optional<Condition> doubtful_arcs(const Toolpath& toolpath, const ControlTable& control,
                                       const Tolerances& tol);

/// That the stock lies where nothing of it is cut; nothing if something is.
std::optional<Condition> cuts_nothing(const Findings& findings);

}  // namespace clearcut::pipeline
