#include "pipeline/tool_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "pipeline/compare.h"
#include "pipeline/run.h"
#include "pipeline/selection/choice.h"
#include "pipeline/selection/strategies.h"
#include "resolve/resolve.h"

namespace clearcut::pipeline {
namespace {

/// A tool and its request.
struct Candidate {
  Tool tool;
  CuttingData cutting;
};

bool positive(double value) {
  return std::isfinite(value) && value > 0;
}

void check(const ToolSpeeds& speeds) {
  if (speeds.cutting_speed && !positive(*speeds.cutting_speed)) {
    throw InputError("--cutting-speed", "must be above 0 m/min");
  }
  if (!std::all_of(speeds.feeds_per_tooth.begin(), speeds.feeds_per_tooth.end(), positive)) {
    throw InputError("--feed-per-tooth", "must be above 0 mm");
  }
}

CuttingData cutting_of(const Tool& tool, std::size_t index, const ToolSpeeds& speeds, CuttingData given) {
  if (!speeds.cutting_speed && speeds.feeds_per_tooth.empty()) return given;
  const bool feeds = !speeds.feeds_per_tooth.empty();
  const double fz = feeds ? speeds.feeds_per_tooth[std::min(index, speeds.feeds_per_tooth.size() - 1)] : 0;
  const auto data = driven(tool, speeds.cutting_speed.value_or(resolve::kDefaultCuttingSpeed), fz);
  given.spindle_rpm = data.spindle_rpm;
  if (feeds) given.feed = data.feed;
  return given;
}

std::vector<Candidate> candidates_of(const Part& part, const ToolSpeeds& speeds, const PlanOptions& options) {
  const auto& tools = options.tools.empty() ? part.tools : options.tools;
  if (tools.empty()) {
    throw InputError("tools",
                     "none to choose from; give several, for example --tool endmill:6 --tool endmill:12");
  }
  check(speeds);
  std::vector<Candidate> all;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    all.push_back({tools[i], cutting_of(tools[i], i, speeds, options.cutting)});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return a.tool.diameter < b.tool.diameter; });
  return all;
}

Objective objective_in(const PlanOptions& options) {
  return parse_objective(options.objective, "--objective");
}

/// Where a named strategy leaves nothing to choose the objective is for the cutters alone.
void leave_objective_to_cutters(PlanOptions& options) {
  const StrategyEntry* named = options.strategy ? strategies_of(options).find(*options.strategy) : nullptr;
  if (named == nullptr || !named->orders.empty()) return;
  options.objective = name_of(ObjectiveKind::kTime);
  options.sources.forget("objective");
}

ToolRun run_of(const Candidate& candidate, const Part& part, PlanOptions options) {
  const Tool& tool = candidate.tool;
  if (objective_in(options).asks_load()) leave_objective_to_cutters(options);
  options.tools = {tool};
  options.cutting = candidate.cutting;
  ToolRun run;
  run.tool = tool;
  try {
    const auto result = plan_part(part, options);
    const auto& figures = result.findings.all;
    const auto& cutting = result.part.workplan.front().operation.cutting;
    run.spindle_rpm = cutting.spindle_rpm.value_or(0);
    run.feed_mm_per_min = cutting.feed ? cutting.feed->mm_per_min() : 0;
    run.fits = true;
    run.clean = figures.clean;
    run.feed_mm = figures.feed_mm;
    run.time_s = figures.time_s;
    run.published_s = kinematics::published_time(result.toolpath).seconds();
    run.unreachable_mm2 = figures.unreachable_mm2;
    run.figures = figures;
  } catch (const InputError& error) {
    run.refusal = error.what();
  }
  return run;
}

std::string name_of_tool(const Tool& tool) {
  return fmt::format("{} {}", name_of(tool.kind), trimmed(tool.diameter, 3));
}

std::vector<std::string> cells(const ToolRun& run, bool fastest) {
  if (!run.fits) return {name_of_tool(run.tool), "does not fit"};
  return {name_of_tool(run.tool) + (fastest ? " *" : ""),
          std::to_string(run.tool.teeth),
          fmt::format("{:.0f}", run.spindle_rpm),
          fmt::format("{:.0f}", run.feed_mm_per_min),
          fmt::format("{:.1f}", run.feed_mm),
          fmt::format("{:.2f}", run.time_s),
          fmt::format("{:.2f}", run.published_s),
          fmt::format("{:.2f}", run.unreachable_mm2),
          run.clean ? "yes" : "NO"};
}

/// Cutters one after the other, by their places in the list of candidates, largest first.
struct Sequence {
  std::vector<std::size_t> tools;
  double time_s = 0;
};

/// Share of a cutter's radius squared for the error of the estimated area of unreachable corners. Our own estimate, not of a text.
constexpr double kCornerError = 0.01;

/// Whether a cutter leaves no more than the smallest one.
bool may_end(const ToolRun& run, const ToolRun& smallest) {
  const double error = kCornerError * run.tool.radius() * run.tool.radius();
  return run.clean && smallest.clean && run.unreachable_mm2 <= smallest.unreachable_mm2 + error;
}

/// Time of `then` on the material left by `first`, with its own speeds; none if this cannot be cut clean.
std::optional<double> rest_time(const Candidate& first, const Candidate& then, const Part& part,
                                PlanOptions options) {
  options.tools = {first.tool, then.tool};
  options.cutting = then.cutting;
  options.shop.rest = true;
  try {
    const auto findings = plan_part(part, options).findings;
    double time = 0;
    for (const auto& feature : findings.features) {
      if (feature.tool_diameter == then.tool.diameter) time += feature.figures.time_s;
    }
    return findings.all.clean ? std::optional(time) : std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Counts plans: every single cutter, then every pair.
class PlanCount {
 public:
  PlanCount(std::size_t tools, CountCallback callback)
      : of_(tools + tools * (tools - 1) / 2), callback_(std::move(callback)) {}
  void at(std::size_t done) const {
    if (callback_) callback_(done, of_);
  }

 private:
  std::size_t of_;
  CountCallback callback_;
};

/// The fastest sequence ending with each cutter; `all` and `runs` are in ascending order of size.
std::vector<std::optional<Sequence>> fastest_to_each(const std::vector<Candidate>& all,
                                                     const std::vector<ToolRun>& runs, const Part& part,
                                                     const ToolSpeeds& speeds, const PlanOptions& options,
                                                     const CountCallback& count) {
  const PlanCount counted(all.size(), count);
  std::size_t done = all.size();
  std::vector<std::optional<Sequence>> best(all.size());
  for (std::size_t i = all.size(); i-- > 0;) {
    if (runs[i].clean) best[i] = Sequence{{i}, runs[i].time_s};
    for (std::size_t larger = i + 1; larger < all.size(); ++larger) {
      counted.at(done++);
      if (!best[larger] || all[larger].tool.diameter <= all[i].tool.diameter) continue;
      const auto rest = rest_time(all[larger], all[i], part, options);
      if (!rest) continue;
      const double time = best[larger]->time_s + *rest + speeds.tool_change_s;
      if (best[i] && time >= best[i]->time_s) continue;
      best[i] = Sequence{best[larger]->tools, time};
      best[i]->tools.push_back(i);
    }
  }
  return best;
}

std::optional<ToolSequence> fastest_of(const std::vector<ToolRun>& runs, const Part& part,
                                       const ToolSpeeds& speeds, const PlanOptions& options,
                                       const CountCallback& count) {
  const auto to_each =
      fastest_to_each(candidates_of(part, speeds, options), runs, part, speeds, options, count);
  const Sequence* best = nullptr;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!to_each[i] || !may_end(runs[i], runs.front())) continue;
    if (best == nullptr || to_each[i]->time_s < best->time_s) best = &*to_each[i];
  }
  if (best == nullptr) return std::nullopt;
  ToolSequence sequence{{}, best->time_s};
  for (const std::size_t i : best->tools) sequence.tools.push_back(runs[i].tool);
  return sequence;
}

std::string load_note(const ToolRun& run) {
  std::string note = name_of_tool(run.tool) + ": ";
  if (const auto& load = run.figures.load)
    note += fmt::format("at most {:.0f} N, {:.1f} J, {:.4g} % of its life, ", load->max_force_n,
                        load->energy_j, 100 * load->wear);
  return note + fmt::format("{:.1f} % climb", 100 * (1 - figure_of(ObjectiveKind::kClimb, run.figures)));
}

std::string text_of(const ToolSequence& sequence) {
  std::string names;
  for (const Tool& tool : sequence.tools) names += (names.empty() ? "" : ", then ") + name_of_tool(tool);
  return names;
}

}  // namespace

CuttingData driven(const Tool& tool, double cutting_speed, double feed_per_tooth) {
  CuttingData data;
  data.spindle_rpm = 1000 * cutting_speed / (kPi * tool.diameter);
  data.feed = MmPerMin::of(feed_per_tooth * tool.teeth * *data.spindle_rpm);
  return data;
}

std::vector<ToolRun> run_tools(const Part& part, const ToolSpeeds& speeds, const PlanOptions& options,
                               const CountCallback& count) {
  const auto all = candidates_of(part, speeds, options);
  const PlanCount counted(all.size(), count);
  std::vector<ToolRun> runs;
  for (const auto& one : all) {
    counted.at(runs.size());
    runs.push_back(run_of(one, part, options));
  }
  return runs;
}

const ToolRun* fastest_clean(const std::vector<ToolRun>& runs) {
  const ToolRun* best = nullptr;
  for (const auto& run : runs) {
    if (run.clean && (!best || run.time_s < best->time_s)) best = &run;
  }
  return best;
}

const ToolRun* best_clean(const std::vector<ToolRun>& runs, const Objective& objective) {
  std::vector<const Figures*> figures;
  for (const ToolRun& run : runs) figures.push_back(run.clean ? &run.figures : nullptr);
  const std::vector<double> costs = costs_of(objective, figures);
  const auto least = std::min_element(costs.begin(), costs.end());
  if (least == costs.end() || !std::isfinite(*least)) return nullptr;
  return &runs[static_cast<std::size_t>(least - costs.begin())];
}

const ToolRun* best_tool(const ToolComparison& comparison) {
  return comparison.objective.asks_load() ? best_clean(comparison.runs, comparison.objective)
                                          : fastest_clean(comparison.runs);
}

std::optional<ToolSequence> fastest_sequence(const Part& part, const ToolSpeeds& speeds,
                                             const PlanOptions& options) {
  return fastest_of(run_tools(part, speeds, options), part, speeds, options, {});
}

ToolComparison compare_tools(const Part& part, const ToolSpeeds& speeds, const PlanOptions& options,
                             const CountCallback& count) {
  ToolComparison comparison{run_tools(part, speeds, options, count), std::nullopt, objective_in(options)};
  const auto& runs = comparison.runs;
  if (std::none_of(runs.begin(), runs.end(), [](const ToolRun& run) { return run.fits; }))
    throw InputError("", runs.front().refusal);
  if (!comparison.objective.asks_load()) comparison.sequence = fastest_of(runs, part, speeds, options, count);
  return comparison;
}

TextTable tool_table(const Part& part, const ToolSpeeds& speeds, const ToolComparison& comparison) {
  TextTable table;
  table.title = part.name + ": each cutter alone";
  table.columns = {{"tool", Align::kLeft},
                   {"Z"},
                   {"rpm"},
                   {"mm/min"},
                   {"feed mm"},
                   {"time s"},
                   {"eq. 9 s"},
                   {"corners mm2"},
                   {"clean", Align::kLeft}};
  const ToolRun* best = best_tool(comparison);
  for (const auto& run : comparison.runs) table.add(cells(run, &run == best));
  const bool by_load = comparison.objective.asks_load();
  table.notes.push_back(fmt::format("* {} alone; corners: out of its reach, left for a smaller one",
                                    by_load ? "best by the objective" : "fastest"));
  if (by_load) {
    for (const auto& run : comparison.runs)
      if (run.fits) table.notes.push_back(load_note(run));
    table.notes.push_back("sequences are compared by time alone: leave out --objective");
  }
  if (comparison.sequence) {
    table.notes.push_back(fmt::format(
        "fastest sequence that leaves no more than the smallest, {:.0f} s a tool change: {}: {:.2f} s",
        speeds.tool_change_s, text_of(*comparison.sequence), comparison.sequence->time_s));
  }
  return table;
}

}  // namespace clearcut::pipeline
