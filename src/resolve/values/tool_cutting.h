// Feeds and speeds belong to a tool: values stated for one tool are not used for another.
#pragma once

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Replaces the operation's cutting data by those stated for its tool.
void take_tool_cutting(Operation& operation, const PlanOptions& options);

/// The operation with another tool of the part, with the cutting data stated for that tool: in the options, else in
/// another operation of the part with this tool. Data of the former tool are removed; requests for the operation are
/// kept.
void change_tool(Operation& operation, int tool, const Part& part, const PlanOptions& options);

}  // namespace clearcut::resolve
