#include "report/selection_table.h"

#include <fmt/format.h>

namespace clearcut::report {
namespace {

std::string time_cell(const CandidateResult& one) {
  if (one.time_s > 0) return fmt::format("{:.1f}", one.time_s);
  return one.least_s > 0 ? fmt::format("> {:.1f}", one.least_s) : "-";
}

}  // namespace

TextTable selection_table(const std::vector<StrategySelection>& selections) {
  TextTable table;
  table.columns = {{"feature", Align::kLeft},
                   {"strategy", Align::kLeft},
                   {"time s"},
                   {"feed mm"},
                   {"outcome", Align::kLeft}};
  for (const auto& selection : selections) {
    std::string feature = selection.feature;
    for (const auto& one : selection.candidates) {
      const std::string strategy = one.stepover.empty() ? one.strategy : one.strategy + " " + one.stepover;
      table.add({feature, strategy, time_cell(one),
                 one.feed_mm > 0 ? fmt::format("{:.1f}", one.feed_mm) : "-", name_of(one.outcome)});
      feature.clear();
    }
  }
  return table;
}

}  // namespace clearcut::report
