// A sheet of copies as one part.
#pragma once

#include <functional>
#include <vector>

#include "model/options/resolved_plan.h"
#include "model/part.h"
#include "model/results/copies_made.h"
#include "options/plan_options.h"

namespace clearcut::inline options {

/// The parts of a sheet as one part.
struct SheetOfCopies {
  Part part;
  CopiesMade made;  ///< none of its parts is counted as clean yet
  /// Of the tools of the part, as PlanOptions::tool_cutting.
  std::vector<ToolCutting> tool_cutting = {};
  /// The plan that the sheet is checked with: each kind is resolved by itself with these options, as it is planned, before it is placed.
  /// Throws as resolve::resolve().
  std::function<ResolvedPlan(const PlanOptions&)> resolved = {};
};

}  // namespace clearcut::inline options
