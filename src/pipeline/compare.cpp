#include "pipeline/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "pipeline/run.h"
#include "pipeline/selection/strategies.h"

namespace clearcut::pipeline {
namespace {

StrategyRun run_of(const std::string& strategy, const Part& part, PlanOptions options) {
  options.strategy = strategy;
  try {
    const PlanResult result = plan_part(part, options);
    return {strategy, result.findings.all, "", kinematics::published_time(result.toolpath)};
  } catch (const InputError& error) {
    return {strategy, std::nullopt, error.what(), {}};
  }
}

/// Length against plain contours at a fixed step: length added or saved by a method.
std::string added(const StrategyRun& row, const StrategyRun* fixed) {
  if (!fixed || !fixed->figures) return "";
  return fmt::format("{:+.1f}", row.figures->feed_mm - fixed->figures->feed_mm);
}

std::vector<std::string> cells(const StrategyRun& row, const StrategyRun* fixed, bool fastest) {
  if (!row.figures) return {row.strategy, row.refusal};
  const auto& f = *row.figures;
  return {row.strategy + (fastest ? " *" : ""),
          fmt::format("{:.1f}", f.feed_mm),
          added(row, fixed),
          f.lower_bound_mm > 0 ? fmt::format("{:.2f}", f.feed_mm / f.lower_bound_mm) : "-",
          std::to_string(f.retracts),
          fmt::format("{:.2f}", f.time_s),
          fmt::format("{:.2f}", row.published.seconds()),
          fmt::format("{:.3f}", f.uncut_thickness_mm),
          fmt::format("{:.2f}", f.uncut_mm2),
          fmt::format("{:.4f}", f.gouge_mm),
          fmt::format("{:.0f}", f.engagement.max_deg),
          fmt::format("{:.0f}", f.engagement.mean_deg),
          f.clean ? "yes" : "NO"};
}

}  // namespace

std::vector<StrategyRun> run_strategies(const Part& part, const PlanOptions& options,
                                        const CountCallback& count) {
  std::vector<StrategyRun> runs;
  const auto names = strategy_names(strategies_of(options));
  for (const auto& name : names) {
    if (count) count(runs.size(), names.size());
    runs.push_back(run_of(name, part, options));
  }
  if (count) count(runs.size(), names.size());
  if (std::none_of(runs.begin(), runs.end(), [](const StrategyRun& run) { return run.figures.has_value(); }))
    throw InputError("", runs.front().refusal);
  return runs;
}

const StrategyRun* fastest_clean(const std::vector<StrategyRun>& runs) {
  const StrategyRun* best = nullptr;
  for (const auto& run : runs) {
    if (!run.figures || !run.figures->clean) continue;
    if (!best || run.figures->time_s < best->figures->time_s) best = &run;
  }
  return best;
}

TextTable strategy_table(const Part& part, const PlanOptions& options, const std::vector<StrategyRun>& rows) {
  TextTable table;
  table.title = part.name;
  table.columns = {{"strategy", Align::kLeft},
                   {"feed mm"},
                   {"vs fixed"},
                   {"x bound"},
                   {"retracts"},
                   {"time s"},
                   {"eq. 9 s"},
                   {"uncut mm"},
                   {"uncut mm2"},
                   {"gouge mm"},
                   {"eng max"},
                   {"mean"},
                   {"clean", Align::kLeft}};
  const StrategyRun* best = fastest_clean(rows);
  const auto fixed =
      std::find_if(rows.begin(), rows.end(), [](const StrategyRun& row) { return row.strategy == "fixed"; });
  for (const auto& row : rows) table.add(cells(row, fixed == rows.end() ? nullptr : &*fixed, &row == best));
  table.notes.push_back(
      "* fastest that is certified clean; vs fixed: mm longer than contours at a fixed step alone");
  table.notes.push_back("x bound: feed mm over the lower bound of the length of any program's feed");
  table.notes.push_back(
      "time: all moves, with the machine's acceleration and cornering; eq. 9: level feed moves, length / "
      "feed + 2 (1 + nd) 0.177 s");
  const StrategyTable& strategies = strategies_of(options);
  for (const auto& name : strategy_names(strategies))
    table.notes.push_back(name + ": " + description_of(name, strategies));
  return table;
}

TextTable compare(const Part& part, const PlanOptions& options) {
  return strategy_table(part, options, run_strategies(part, options));
}

}  // namespace clearcut::pipeline
