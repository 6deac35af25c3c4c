// Conclusions from the moves of a program: moves too far from the work, displaced holes by rounded digits, the
// possible stock where none is stated, and findings under compensation for wear.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/control.h"
#include "model/move.h"
#include "model/options/post_options.h"
#include "model/options/shop_options.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "pipeline/steps/certify.h"

namespace clearcut::pipeline {

/// The condition `far-move` for the farthest move: below the top of the work, if it is more than 50 mm plus the
/// cutter's width beside the stock (or the features, if no stock is stated); above the top, if more than 2 m away.
std::optional<Condition> far_move(const Part& part, const Toolpath& toolpath);

/// Warns of each hole drilled and each slot milled beside its place by more than tol.gouge, but no more than the
/// rounding of the program's digits, with a remedy. A cutter as wide as its hole or slot cannot keep a distance from
/// the wall, so the fault remains.
void explain_rounded_places(PlanResult& result, const ResolvedPlan& plan);

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

/// The part with the cutters of `numbers` larger all round by `wear`, mm.
Part worn(Part part, const std::vector<int>& numbers, double wear);

/// What is asked of a program whose control compensates for wear.
struct WearQuestion {
  double range = 0;                    ///< mm that D words may be off 0 either way
  std::vector<int> tools;              ///< T words whose paths are compensated
  const Part* part = nullptr;          ///< with the sections' workingsteps
  const Toolpath* toolpath = nullptr;  ///< with 0 in D
};

/// A program as it is read with other D words, and what is found about it with cutters as much off their size.
struct WornProgram {
  Toolpath toolpath;
  Findings findings;
};

/// Adds what is wrong at either end of the range alone, where cutters are off their size by as much as D words hold, and says for
/// which range the findings hold. Faults of features whose passes no D word shifts are not added: their cutters may not be off their
/// size. `read_at`: the program with these D words; the message of an InputError that it throws gets the end of the range.
void check_wear(Findings& findings, const WearQuestion& question,
                const std::function<WornProgram(double)>& read_at);

}  // namespace clearcut::pipeline
