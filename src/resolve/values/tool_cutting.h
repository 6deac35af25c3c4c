// Feeds and speeds belong to a tool: what is stated for one does not drive another.
#pragma once

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Puts what is stated for the tool of the operation in the place of what the operation says.
void take_tool_cutting(Operation& operation, const PlanOptions& options);

/// The operation with another tool of the part, driven as is stated for that tool: in the options, else by another operation of
/// the part that uses it. What was stated for the tool before goes; what was asked for the operation stays.
void change_tool(Operation& operation, int tool, const Part& part, const PlanOptions& options);

}  // namespace clearcut::resolve
