// Output of compare, tools and info with --json, and the options themselves. The fields are in docs/command-line.md.
#pragma once

#include <clearcut/part.h>
#include <clearcut/plan.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace clearcut::cli {

std::string strategies_json(const Part& part, const std::vector<StrategyRun>& runs);
std::string tools_json(const Part& part, const ToolComparison& comparison);
/// Information on a part, or on one set-up of a job.
struct PartInfo {
  Part part;
  DrawingOverview overview;       ///< the outlines of a drawing, else nothing
  std::vector<std::string> asks;  ///< values to be stated before the part can be planned
  Diagnostics found;
  bool is_drawing = false;
};

/// For one part directly; for several set-ups with the field "setups", each like one part.
std::string infos_json(const std::vector<PartInfo>& infos);

/// Every option of every command: names, value, help, group, values, and whether it takes several values, names a
/// file, or is positional.
std::string options_json(const CLI::App& app);

}  // namespace clearcut::cli
