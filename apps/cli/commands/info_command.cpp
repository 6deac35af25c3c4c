#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/part.h>
#include <clearcut/plan.h>
#include <clearcut/text.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "arguments/plan_arguments.h"
#include "commands/commands.h"
#include "terminal/json_tables.h"
#include "terminal/output.h"
#include "terminal/progress.h"

namespace clearcut::cli {
namespace {

std::string extent(const Box& box) {
  return fmt::format("x {}..{} y {}..{}", trimmed(box.min.x, 3), trimmed(box.max.x, 3), trimmed(box.min.y, 3),
                     trimmed(box.max.y, 3));
}

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string shape(const Feature& feature) {
  std::size_t islands = 0, edges = 0, arcs = 0;
  for (const auto& region : feature.target) {
    islands += region.islands().size();
    for (const auto& edge : region.edges()) {
      ++edges;
      arcs += edge.is_arc() ? 1u : 0u;
    }
  }
  return fmt::format("{}, {}, {} ({})", counted(feature.target.size(), "region"), counted(islands, "island"),
                     counted(edges, "edge"), counted(arcs, "arc"));
}

void print_feature(const Feature& feature, double largest_cutter) {
  print_line(fmt::format("{}  {}  {}", feature.name, name_of(feature.kind), feature.source));
  print_line(fmt::format("    z {} to {}, {}, area {} mm2", trimmed(feature.top_z, 3),
                         trimmed(feature.floor_z, 3), extent(box(feature.target)),
                         trimmed(area(feature.target), 2)));
  print_line(
      fmt::format("    {}, largest cutter {}", shape(feature),
                  largest_cutter > kOpenReach / 2 ? "any (open)" : trimmed(largest_cutter, 3) + " mm"));
}

void print_part(const Part& part) {
  print_line(fmt::format("{}: {}, {}, {}", part.source_file, counted(part.features.size(), "feature"),
                         counted(part.workplan.size(), "workingstep"), counted(part.tools.size(), "tool")));
  if (part.stock) {
    print_line(fmt::format("stock {} z {}..{}", extent(part.stock->plan), trimmed(part.stock->z_bottom, 3),
                           trimmed(part.stock->z_top, 3)));
  }
  for (const auto& tool : part.tools) {
    print_line(fmt::format("T{} {} {} mm", tool.number, name_of(tool.kind), trimmed(tool.diameter, 3)));
  }
  const std::vector<double> cutters = largest_cutters(part, Tolerances{});
  for (std::size_t i = 0; i < cutters.size(); ++i) print_feature(part.features[i], cutters[i]);
  for (const auto& step : part.workplan) {
    const std::string& strategy = step.operation.strategy_hint;
    print_line(fmt::format("step {} -> {}{}", step.name, feature_of(part, step).name,
                           strategy.empty() ? "" : ", strategy " + strategy));
  }
}

std::string size_of(const OutlineSummary& one) {
  if (one.diameter) return "circle of " + trimmed(*one.diameter, 3);
  return trimmed(one.box.width(), 3) + " x " + trimmed(one.box.height(), 3);
}

/// One line an outline, as many as a person reads; the rest is counted.
void print_overview(const std::string& file, const DrawingOverview& overview) {
  constexpr std::size_t kMost = 200;
  Box all;
  for (const auto& one : overview.outlines) all.add(one.box);
  print_line(fmt::format(
      "{}: {}, {} to follow{}", file, counted(overview.outlines.size(), "outline"),
      counted(overview.lines, "line"),
      all.empty() ? "" : ", " + trimmed(all.width(), 3) + " x " + trimmed(all.height(), 3) + " mm"));
  for (std::size_t i = 0; i < std::min(kMost, overview.outlines.size()); ++i) {
    const auto& one = overview.outlines[i];
    print_line(fmt::format("  {:>3}  layer {}, {} mm, {}, area {} mm2{}{}: {}{}", one.number, one.layer,
                           size_of(one), extent(one.box), trimmed(one.area, 2),
                           one.within > 0 ? ", within " + std::to_string(one.within) : "",
                           one.depth ? ", depth " + trimmed(*one.depth, 3) : ", no depth", one.role,
                           one.says_role ? "" : " (not said)"));
  }
  if (overview.outlines.size() > kMost)
    print_line(fmt::format("  and {} more", overview.outlines.size() - kMost));
}

bool has_depths(const DrawingOverview& overview) {
  return overview.lines_have_depths && std::all_of(overview.outlines.begin(), overview.outlines.end(),
                                                   [](const auto& one) { return one.depth.has_value(); });
}

const std::string kNoDepth = "how deep; --depth MM, or in layers' names as in POCKET_D5";

bool left_out_any(const Diagnostics& found) {
  return std::any_of(found.items().begin(), found.items().end(),
                     [](const Diagnostic& item) { return item.severity == Severity::kSkipped; });
}

/// A readable drawing is shown even if data needed for a plan is missing: the missing data is reported.
PartInfo info_of(const PlanArguments& arguments) {
  PartInfo info;
  info.part = arguments.read_overview(info.overview);
  info.found = info.part.diagnostics;
  info.is_drawing = info.part.features.empty();
  if (!info.is_drawing) return info;
  if (!info.overview.question.empty()) {
    info.asks.push_back(info.overview.question);
    if (!has_depths(info.overview)) info.asks.push_back(kNoDepth);
    return info;
  }
  // If nothing was left out of the overview, a plan would not find more.
  if (!info.overview.missing.empty() && !left_out_any(info.found)) {
    info.asks.push_back(info.overview.missing);
    return info;
  }
  try {
    info.part = arguments.read(Block::kWhole);
  } catch (const InputError& missing) {
    info.asks.emplace_back(missing.what());
  }
  return info;
}

/// Infos of every set-up of a job with several, or of the chosen one.
std::vector<PartInfo> infos_of(const PlanArguments& arguments) {
  ProgressLine line(kStops);
  line.expect("reading " + arguments.input());
  const int count = arguments.setup().number > 0 ? 0 : setup_count_of(arguments.input());
  if (count == 0) {
    PartInfo info = info_of(arguments);
    info.part = arguments.with_given_tools(std::move(info.part));
    return {info};
  }
  std::vector<PartInfo> infos;
  for (int number = 1; number <= count; ++number) {
    PlanArguments one = arguments;
    one.setup().number = number;
    infos.push_back(info_of(one));
  }
  return infos;
}

void print_info(const PartInfo& info) {
  print(info.found, true);
  if (info.is_drawing) print_overview(info.part.source_file, info.overview);
  for (const auto& ask : info.asks) print_line("to be said: " + ask);
  if (info.asks.empty()) print_part(info.part);
}

/// Workplans of files refused later are listed before; the command's reading then reports the reason.
void print_workplans_of_ap238(const std::string& input) {
  const std::string extension = std::filesystem::path(input).extension().string();
  if (extension == ".dxf" || extension == ".svg" || extension == ".toml" || extension == ".json") return;
  std::vector<std::string> lines;
  try {
    lines = ap238_lines(read_file(input), input);
  } catch (const InputError&) {
    return;  // reported during reading of the part
  }
  for (const std::string& line : lines) print_line(line);
}

void print_infos(const std::vector<PartInfo>& infos, bool as_json) {
  if (as_json) return print_line(infos_json(infos));
  for (std::size_t i = 0; i < infos.size(); ++i) {
    if (infos.size() > 1)
      print_line(fmt::format("{}set-up {} of {}", i > 0 ? "\n" : "", i + 1, infos.size()));
    print_info(infos[i]);
  }
}

}  // namespace

void add_info_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("info", "List features, cutters that fit, and problems of a part");
  command->group("Reading");
  auto state = std::make_shared<PlanArguments>();
  auto as_json = std::make_shared<bool>(false);
  state->add_info_options(*command);
  command->option_defaults()->group("Output");
  command->add_flag("--json", *as_json, "Print JSON");
  command->callback([state, as_json, &exit_code] {
    print_workplans_of_ap238(state->input());
    print_infos(infos_of(*state), *as_json);
    exit_code = kClean;
  });
}

}  // namespace clearcut::cli
