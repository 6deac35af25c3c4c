// Reasons why an option had no effect in a finished plan; the rows of the table of options refer to these functions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/machine.h"
#include "model/move.h"
#include "model/options/resolved_plan.h"
#include "model/results/strategy_selection.h"
#include "options/plan_options.h"
#include "options/row.h"

namespace clearcut::inline options {

/// A finished plan and the options given for it.
struct Situation {
  const ResolvedPlan& plan;
  const PlanOptions& asked;
  const Toolpath& toolpath;  ///< as planned, before it was written
  const std::vector<StrategySelection>& selections;
  std::optional<MotionPlanner> planner;  ///< of the machine, else of the control
};

/// The kind of input of a part.
InputKinds input_kind_of(const Part& part);

/// Why a row has no effect on input of this kind: "has no effect on a STEP solid; it serves ..."; "" if it has one.
std::string idle_on_input(const Row& row, InputKinds input);

/// The kind of work by which `step` makes its feature.
Works work_of(const Part& part, const Workingstep& step);

/// The kinds of work of a plan. Bits of Works.
unsigned works_of(const ResolvedPlan& plan);

/// "pockets, slots, steps and faces, profiles".
std::string names_of_works(unsigned works);

/// Why a row has no effect on a part with these kinds of work: "it serves pockets and faces, and the part has none"; ""
/// if it has one.
std::string idle_on_works(const Row& row, unsigned works);

// Each function returns the reason in words that follow "has no effect: ", or "" if the option has an effect.
std::string cuts_through_nothing(const Situation& at);
std::string frees_nothing(const Situation& at);
std::string without_tabs(const Situation& at);
std::string leaves_no_tabs(const Situation& at);
std::string leaves_no_stock_on_walls(const Situation& at);
std::string leaves_no_stock_on_floors(const Situation& at);
std::string loads_no_mill(const Situation& at);
std::string follows_no_strategy(const Situation& at);
std::string enters_otherwise(const Situation& at);
std::string without_zigzag(const Situation& at);
std::string without_contours(const Situation& at);
std::string without_reflex_corners(const Situation& at);
std::string without_start(const Situation& at);
std::string without_tour(const Situation& at);
std::string without_objective(const Situation& at);
std::string without_ramps(const Situation& at);
std::string without_helix(const Situation& at);
std::string enters_no_hole(const Situation& at);
std::string without_leads(const Situation& at);
std::string without_margin(const Situation& at);
std::string without_open_sides(const Situation& at);
std::string without_links(const Situation& at);
std::string plunges_nowhere(const Situation& at);
std::string without_slot_feed(const Situation& at);
std::string without_feed_rule(const Situation& at);
std::string has_one_mill(const Situation& at);
std::string finishes_nothing(const Situation& at);
std::string finishes_no_walls(const Situation& at);
std::string writes_no_compensation(const Situation& at);
std::string finishes_no_floor(const Situation& at);
std::string relieves_no_corner(const Situation& at);
std::string plans_corners_otherwise(const Situation& at);
std::string bears_on_no_feeds(const Situation& at);
std::string changes_no_feeds(const Situation& at);
std::string without_leaning_walls(const Situation& at);
std::string makes_no_copies(const Situation& at);
std::string fills_no_sheet(const Situation& at);
std::string states_no_toolpaths(const Situation& at);

}  // namespace clearcut::inline options
