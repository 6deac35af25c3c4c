#include "report/value_table.h"

namespace clearcut::report {
namespace {

std::string owner_of(const Part& part, int step) {
  if (step < 0) return "whole plan";
  const Workingstep& planned = part.workplan.at(static_cast<std::size_t>(step));
  return std::to_string(step + 1) + " " +
         (planned.name.empty() ? feature_of(part, planned).name : planned.name);
}

}  // namespace

TextTable value_table(const Part& part, const std::vector<ResolvedValue>& values) {
  TextTable table;
  table.title = "Values of the plan";
  table.columns = {{"workingstep", Align::kLeft}, {"name", Align::kLeft},   {"value"},
                   {"unit", Align::kLeft},        {"origin", Align::kLeft}, {"source", Align::kLeft}};
  for (const ResolvedValue& value : values) {
    table.add({owner_of(part, value.step), value.name, value.value, value.unit, name_of(value.source.origin),
               value.source.text});
  }
  return table;
}

}  // namespace clearcut::report
