// What compare, tools and info print with --json, and the options themselves. The fields are in docs/command-line.md.
#pragma once

#include <clearcut/part.h>
#include <clearcut/plan.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace clearcut::cli {

std::string strategies_json(const Part& part, const std::vector<StrategyRun>& runs);
std::string tools_json(const Part& part, const ToolComparison& comparison);
/// What is known of a part, or of one set-up of a job.
struct PartInfo {
  Part part;
  DrawingOverview overview;       ///< the outlines of a drawing, else nothing
  std::vector<std::string> asks;  ///< what must be said before the part can be planned
  Diagnostics found;
  bool is_drawing = false;
};

/// Of one part as it is; of several set-ups with the field "setups", each as one part.
std::string infos_json(const std::vector<PartInfo>& infos);

/// Every option of every command: names, value, help, group, values, and whether it takes many, names a file, is told by its place.
std::string options_json(const CLI::App& app);

}  // namespace clearcut::cli
