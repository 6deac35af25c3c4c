#include "report/contest_table.h"

#include <fmt/format.h>

namespace clearcut::report {
namespace {

std::string time_cell(const Contestant& one) {
  if (one.time_s > 0) return fmt::format("{:.1f}", one.time_s);
  return one.least_s > 0 ? fmt::format("> {:.1f}", one.least_s) : "-";
}

}  // namespace

TextTable contest_table(const std::vector<Contest>& contests) {
  TextTable table;
  table.columns = {{"feature", Align::kLeft},
                   {"strategy", Align::kLeft},
                   {"time s"},
                   {"feed mm"},
                   {"outcome", Align::kLeft}};
  for (const auto& contest : contests) {
    std::string feature = contest.feature;
    for (const auto& one : contest.contestants) {
      const std::string strategy = one.stepover.empty() ? one.strategy : one.strategy + " " + one.stepover;
      table.add({feature, strategy, time_cell(one),
                 one.feed_mm > 0 ? fmt::format("{:.1f}", one.feed_mm) : "-", name_of(one.outcome)});
      feature.clear();
    }
  }
  return table;
}

}  // namespace clearcut::report
