// Programs that exist: how they are read, by what options say of the machine and of the tools, and their feeds
// adapted to the load: only their F words change, and no other text.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "options/program_question.h"
#include "pipeline/check.h"
#include "read/gcode/program/program.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// The machine's places, the subprograms beside the file, and the radii of `tools` for programs with cutter compensation; tools
/// without a number have the number that a plan gives them. Dialect, safe height and tools by hand are the caller's.
read::gcode::ReadControllerOptions reading_of(const PlanOptions& options, const std::vector<Tool>& tools,
                                              const std::string& file);

/// Level moves at the tool's usual feed (the feed of the greatest part of its cutting length) are raised to the feed
/// allowed by the rule of `options.shop.feed_by` over their whole block, at most to the cap; every feed above the
/// allowed one is lowered. If no reference feed is stated the usual feed of each tool is the feed at the reference.
///
/// Throws InputError if no rule is requested, for Klartext, for a program refused by the reader, and if the moves of
/// the new text differ from those of the old one.
ProgramFeeds feeds_of_program(const ProgramQuestion& question, const std::string& program,
                              const std::string& program_name, const PlanOptions& options);

}  // namespace clearcut::pipeline
