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
/// `overview` holds the outlines of a drawing, else nothing; `asks` is what must be said before the part can be planned.
std::string info_json(const Part& part, const DrawingOverview& overview,
                      const std::vector<std::string>& asks);

/// Every option of every command: names, value, help, group, values, and whether it takes many, names a file, is told by its place.
std::string options_json(const CLI::App& app);

}  // namespace clearcut::cli
