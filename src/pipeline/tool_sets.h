// Finds the one of several cutters, or the sequence of them, that cuts a part fastest (CPO-rho section 4).
//
//   paper   here                        unit     meaning
//   R_i     Tool::radius()              mm
//   Z_i     Tool::teeth
//   f_z,i   ToolSpeeds::feeds_per_tooth mm
//   V_c     ToolSpeeds::cutting_speed   m/min
//   n       CuttingData::spindle_rpm    rpm      1000 V_c / (pi D)
//   V_f     CuttingData::feed           mm/min   f_z Z n
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/options/tour_options.h"
#include "model/results/findings.h"
#include "options/tool_speeds.h"
#include "pipeline/compare.h"
#include "report/words/text_table.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// Spindle and feed of a tool with `feed_per_tooth`. Units and formulas above.
CuttingData driven(const Tool& tool, double cutting_speed, double feed_per_tooth);

/// Runs every tool of the options (else of the part) by itself on every feature, smallest first. Throws InputError
/// without tools and for speeds not above 0. Cost one plan each.
std::vector<ToolRun> run_tools(const Part& part, const ToolSpeeds& speeds, const PlanOptions& options,
                               const CountCallback& count = {});

/// The fastest run certified clean; null if none is.
const ToolRun* fastest_clean(const std::vector<ToolRun>& runs);

/// The best run certified clean by an objective of load; null if none is.
const ToolRun* best_clean(const std::vector<ToolRun>& runs, const Objective& objective);

/// The fastest sequence that leaves no more than the smallest cutter by itself; none if no sequence can be cut clean.
/// Each cutter cuts the areas out of reach of larger ones, which depend only on the previous cutter: a shortest path
/// over pairs. Cost: one plan for every pair of tools.
std::optional<ToolSequence> fastest_sequence(const Part& part, const ToolSpeeds& speeds,
                                             const PlanOptions& options);

/// The best run, marked in tables; null if none is clean.
const ToolRun* best_tool(const ToolComparison& comparison);

/// Throws InputError if no cutter can be used. `count` is called for the plans of single cutters and of pairs.
ToolComparison compare_tools(const Part& part, const ToolSpeeds& speeds, const PlanOptions& options,
                             const CountCallback& count = {});

/// The table, with the best clean cutter marked, and the fastest sequence or the load of each below.
TextTable tool_table(const Part& part, const ToolSpeeds& speeds, const ToolComparison& comparison);

}  // namespace clearcut::pipeline
