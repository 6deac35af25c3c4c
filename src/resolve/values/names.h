// Converts the names used in options and files into values, which no other file does, and lists the decided values
// with their sources, for people and certificates.
#pragma once

#include <string>

#include "model/options/resolved_plan.h"
#include "model/options/shop_options.h"
#include "model/options/strategy_entry.h"
#include "model/part.h"
#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// The row of a strategy; null for "auto". Throws InputError at `place`, listing the existing names.
const StrategyEntry* strategy_named(const std::string& name, const StrategyTable& strategies,
                                    const std::string& place);

/// The strategy here for a strategy name of a STEP-NC file: "contour" for "contour_parallel". "" if there is no
/// equivalent.
std::string strategy_of_stepnc(const std::string& name);

/// "helix", "ramp", "zigzag", "plunge". Throws InputError at `place`.
EntryKind entry_named(const std::string& name, const std::string& place);

/// "climb", "conventional". Throws InputError at `place`.
CutDirection direction_named(const std::string& name, const std::string& place);
/// "off", "flood", "mist", "both".
Coolant coolant_named(const std::string& name, const std::string& place);
const char* name_of(CutDirection direction);
/// "chip", "removal".
const char* name_of(FeedBy by);

/// "inside-out", "outside-in". Throws InputError at `place`.
ContourOrder order_named(const std::string& name, const std::string& place);
const char* name_of(ContourOrder order);

const char* name_of(Finish finish);

/// "square", "triangular". Throws InputError at `place`.
TabShape tab_shape_named(const std::string& name, const std::string& place);
const char* name_of(TabShape shape);

/// Published method or Clearcut's own: "bisector" or "shortest" passages, a "corner" or "round" contours at reflex
/// corners, the "published" grid or "ours", the "published" solver or the "modern" one; true for the published one.
/// Throw InputError at `place`.
bool is_bisector_passage(const std::string& name, const std::string& place);
bool is_reflex_corner(const std::string& name, const std::string& place);
bool is_published_grid(const std::string& name, const std::string& place);
bool is_published_solver(const std::string& name, const std::string& place);

/// Place in the input of a step's operation: the source of all values without a source of their own.
Source read_source(const Part& part, const Workingstep& step);

/// Appends the values of one step of `plan` to plan.values; `sources` contains the sources that differ from the
/// operation's place in the input.
void list_step(ResolvedPlan& plan, int step, const Sources& sources, const PlanOptions& options);

/// Appends the values of the plan as a whole.
void list_plan(ResolvedPlan& plan, const PlanOptions& options);

}  // namespace clearcut::resolve
