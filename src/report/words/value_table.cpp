#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "report/words/text_table.h"

namespace clearcut::report {
namespace {

/// Steps sharing a value, by their numbers from 0.
using Steps = std::set<int>;

/// "2 WS POCKET1" of one step, "all" of all there are, else "1-4, 7".
std::string owner_of(const Part& part, const Steps& steps) {
  if (*steps.begin() < 0) return "whole plan";
  if (steps.size() == 1) {
    const Workingstep& planned = part.workplan.at(static_cast<std::size_t>(*steps.begin()));
    return std::to_string(*steps.begin() + 1) + " " +
           (planned.name.empty() ? feature_of(part, planned).name : planned.name);
  }
  if (steps.size() == part.workplan.size()) return "all";
  std::string text;
  for (auto step = steps.begin(); step != steps.end();) {
    const int first = *step;
    int last = first;
    while (++step != steps.end() && *step == last + 1) ++last;
    text += (text.empty() ? "" : ", ") + std::to_string(first + 1);
    if (last > first) text += "-" + std::to_string(last + 1);
  }
  return text;
}

/// Values that differ only in their step, combined.
struct SharedValue {
  const ResolvedValue* value = nullptr;
  Steps steps;
};

/// In the order of first occurrence of the names, and of the values of each name; values of the whole plan last, in
/// the listed order.
std::vector<SharedValue> shared_values(const std::vector<ResolvedValue>& values) {
  using Alike = std::tuple<bool, std::string, std::string, std::string, int, std::string>;
  std::map<std::string, std::size_t> order;
  std::map<Alike, std::size_t> found;
  std::vector<SharedValue> shared;
  for (const ResolvedValue& value : values) {
    order.try_emplace(value.name, order.size());
    const Alike alike{
        value.step < 0,   value.name, value.value, value.unit, static_cast<int>(value.source.origin),
        value.source.text};
    const auto [at, is_new] = found.try_emplace(alike, shared.size());
    if (is_new) shared.push_back({&value, {}});
    shared[at->second].steps.insert(value.step);
  }
  std::stable_sort(shared.begin(), shared.end(), [&](const SharedValue& a, const SharedValue& b) {
    const bool of_whole_a = a.value->step < 0, of_whole_b = b.value->step < 0;
    if (of_whole_a != of_whole_b) return of_whole_b;
    return !of_whole_a && order.at(a.value->name) < order.at(b.value->name);
  });
  return shared;
}

}  // namespace

TextTable value_table(const Part& part, const std::vector<ResolvedValue>& values) {
  TextTable table;
  table.title = "Values of the plan";
  table.columns = {{"workingsteps", Align::kLeft}, {"name", Align::kLeft},   {"value"},
                   {"unit", Align::kLeft},         {"origin", Align::kLeft}, {"source", Align::kLeft}};
  bool by_numbers = false;  // some row names steps only by their numbers
  for (const SharedValue& shared : shared_values(values)) {
    by_numbers = by_numbers || (shared.steps.size() > 1 && shared.steps.size() < part.workplan.size());
    const ResolvedValue& value = *shared.value;
    table.add({owner_of(part, shared.steps), value.name, value.value, value.unit,
               name_of(value.source.origin), value.source.text});
  }
  if (by_numbers) {
    std::string names;
    for (int step = 0; step < static_cast<int>(part.workplan.size()); ++step)
      names += (step == 0 ? "" : ", ") + owner_of(part, {step});
    table.notes.push_back("Workingsteps: " + names);
  }
  return table;
}

}  // namespace clearcut::report
