#include "resolve/values/tool_cutting.h"

#include <algorithm>

namespace clearcut::resolve {
namespace {

ToolCutting stated_for(int tool, const PlanOptions& options) {
  const auto index = static_cast<std::size_t>(tool);
  return index < options.tool_cutting.size() ? options.tool_cutting[index] : ToolCutting{};
}

/// Cutting data of a tool in the part's own operations.
ToolCutting used_with(int tool, const Part& part) {
  const auto step = std::find_if(part.workplan.begin(), part.workplan.end(),
                                 [&](const Workingstep& one) { return one.operation.tool == tool; });
  if (step == part.workplan.end()) return {};
  return {true, step->operation.cutting, step->operation.stepdown, step->operation.stepover};
}

template <typename Value>
void set_if(std::optional<Value>& target, const std::optional<Value>& value) {
  if (value) target = value;
}

template <typename Value>
void drop_if_same(std::optional<Value>& target, const std::optional<Value>& value) {
  if (value && target == value) target.reset();
}

void take(Operation& operation, const ToolCutting& tool) {
  if (!tool.stated) return;
  CuttingData& cutting = operation.cutting;
  set_if(cutting.feed, tool.cutting.feed);
  set_if(cutting.plunge_feed, tool.cutting.plunge_feed);
  set_if(cutting.ramp_feed, tool.cutting.ramp_feed);
  set_if(cutting.slot_feed, tool.cutting.slot_feed);
  set_if(cutting.spindle_rpm, tool.cutting.spindle_rpm);
  cutting.spindle_clockwise = tool.cutting.spindle_clockwise;
  set_if(cutting.coolant, tool.cutting.coolant);
  set_if(operation.stepdown, tool.stepdown);
  set_if(operation.stepover, tool.stepover);
}

/// Removes the values of `tool`, unless another source stated them.
void take_back(Operation& operation, const ToolCutting& tool) {
  if (!tool.stated) return;
  CuttingData& cutting = operation.cutting;
  drop_if_same(cutting.feed, tool.cutting.feed);
  drop_if_same(cutting.plunge_feed, tool.cutting.plunge_feed);
  drop_if_same(cutting.ramp_feed, tool.cutting.ramp_feed);
  drop_if_same(cutting.slot_feed, tool.cutting.slot_feed);
  drop_if_same(cutting.spindle_rpm, tool.cutting.spindle_rpm);
  if (cutting.spindle_clockwise == tool.cutting.spindle_clockwise) cutting.spindle_clockwise = true;
  drop_if_same(cutting.coolant, tool.cutting.coolant);
  drop_if_same(operation.stepdown, tool.stepdown);
  drop_if_same(operation.stepover, tool.stepover);
}

/// Values requested for all operations, on the command line or by [plan] of a job, take precedence over a tool's
/// values.
ToolCutting without_what_is_asked(ToolCutting tool, const PlanOptions& options) {
  const auto drop = [&](auto& value, const auto& asked, const char* name) {
    if (asked || options.sources.find(name)) value.reset();
  };
  drop(tool.cutting.feed, options.cutting.feed, "feed");
  drop(tool.cutting.plunge_feed, options.cutting.plunge_feed, "plunge-feed");
  drop(tool.cutting.ramp_feed, options.cutting.ramp_feed, "ramp-feed");
  drop(tool.cutting.slot_feed, options.cutting.slot_feed, "slot-feed");
  drop(tool.cutting.spindle_rpm, options.cutting.spindle_rpm, "spindle");
  drop(tool.cutting.coolant, options.cutting.coolant, "coolant");
  drop(tool.stepdown, options.stepdown, "stepdown");
  return tool;
}

}  // namespace

void take_tool_cutting(Operation& operation, const PlanOptions& options) {
  take(operation, without_what_is_asked(stated_for(operation.tool, options), options));
}

void change_tool(Operation& operation, int tool, const Part& part, const PlanOptions& options) {
  ToolCutting before = stated_for(operation.tool, options), after = stated_for(tool, options);
  const bool own_tools = options.tools.empty();
  if (!after.stated && own_tools) after = used_with(tool, part);
  if (!before.stated && own_tools && after.stated) before = used_with(operation.tool, part);
  take_back(operation, without_what_is_asked(before, options));
  operation.tool = tool;
  take(operation, without_what_is_asked(after, options));
}

}  // namespace clearcut::resolve
