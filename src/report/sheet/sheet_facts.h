// Facts of a set-up sheet, as numbers and sentences.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"

namespace clearcut::report {

/// mm/min, slowest and fastest; low above high: none.
struct DrivenFeeds {
  double low = HUGE_VAL;
  double high = 0;
};
/// Feeds of a workingstep along its passes, without plunges, ramps, leads and links.
DrivenFeeds feeds_of_cuts(const Toolpath& toolpath, int workingstep);
/// Straight down.
DrivenFeeds feeds_of_plunges(const Toolpath& toolpath, int workingstep);
/// "12000", or "8000, 12000" if sections of the workingstep differ.
std::string speeds_of(const Toolpath& toolpath, int workingstep);

/// Extents of the motion of all tools' tips, mm.
struct Extents {
  Box plan;
  double low = 0, high = 0;
};
/// Extents of cuts only, or with rapids. Empty without moves.
Extents extents_of(const Toolpath& toolpath, bool with_rapids);

/// Required projection of a tool from its holder, mm: down to its deepest cut below the top of the material, plus
/// kAboveTop.
inline constexpr double kAboveTop = 5;
double stickout_of(const Part& part, const Toolpath& toolpath, int tool);

/// Numbers of the tools in the order of their calls in the program, each once.
std::vector<int> tools_called(const Toolpath& toolpath);

/// Number of tool changes of the program.
int tool_changes(const Toolpath& toolpath);

/// Coolant of a tool while cutting, in the order of the program, each once: "off", "flood, mist", "flood and mist".
std::string coolant_of_tool(const Toolpath& toolpath, int tool);

/// The findings of workingsteps, in the program's order of cutting; uncut ones come last.
std::vector<FeatureFindings> in_order_of_cutting(const Findings& findings, const Toolpath& toolpath);

/// " 60 degrees" between the flanks of a cone, " 5 degrees a side" of a tapered end mill; "" for other tools.
std::string angle_of(const Tool& tool);

/// Seconds of the operations cut by a tool.
double time_of_tool(const Findings& findings, int tool);

/// Position of X0 Y0 Z0 on the stock: "left side, front side, top", "middle of the width, ...", "20 mm right of the
/// left side". `unit_mm` and `unit`: unit of printed lengths.
std::string zero_on(const Stock& stock, double unit_mm, const std::string& unit);

}  // namespace clearcut::report
