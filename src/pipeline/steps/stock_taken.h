// Conclusions from the moves of a program without a stated part: its possible stock, and the open conditions.
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

/// The box swept by feed moves below `top`, mm; nothing if none goes below. Unknown tools count by their centres.
std::optional<Stock> box_of_cuts(const Toolpath& toolpath, const std::vector<Tool>& tools, double top);

/// The highest move with the tool working above `top`, mm: a lateral feed move at a height to which the tool
/// descended at the feed, or at the rapid from its crossing height. Lateral feed moves at a height to which the tool
/// has risen do not count. Null: there is none.
const Move* work_above(const Toolpath& toolpath, double top);

/// The condition that this box was assumed as the stock.
Condition stock_taken(const Stock& stock);

/// The condition that the support below the stock may be cut as deep as the program feeds below the stock; nothing if
/// the program does not go below.
std::optional<Condition> below_stock(const Toolpath& toolpath, const Stock& stock);

/// The condition that arcs with two different radii run as they were read; nothing if no radii differ by more than
/// `tol.uncut`.
std::optional<Condition> doubtful_arcs(const Toolpath& toolpath, const ControlTable& control,
                                       const Tolerances& tol);

/// The condition that the stock is out of reach of all cuts; nothing if some of it is cut.
std::optional<Condition> cuts_nothing(const Findings& findings);

}  // namespace clearcut::pipeline
