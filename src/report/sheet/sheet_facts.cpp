#include "report/sheet/sheet_facts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>

#include "base/text.h"
#include "base/tolerances.h"

namespace clearcut::report {
namespace {

/// Words for places along one axis of the stock.
struct AxisWords {
  const char* low_side;
  const char* high_side;
  const char* middle;
  const char* beyond;  ///< on the stock's side of the low side: "right of"
};
constexpr AxisWords kAlongX{"left side", "right side", "middle of the width", "right of"};
constexpr AxisWords kAlongY{"front side", "back side", "middle of the depth", "behind"};
constexpr AxisWords kAlongZ{"underside", "top", "middle of the height", "above"};

/// Position of zero between two sides at `low` and `high`, mm; lengths are written in `unit`, of `unit_mm` mm.
std::string between(double low, double high, const AxisWords& words, double unit_mm,
                    const std::string& unit) {
  if (std::abs(low) <= kSamePlaceMm) return words.low_side;
  if (std::abs(high) <= kSamePlaceMm) return words.high_side;
  if (std::abs(low + high) <= kSamePlaceMm) return words.middle;
  const std::string away = trimmed(std::abs(low) / unit_mm, unit_mm == 1 ? 3 : 4) + " " + unit + " ";
  return away + (low < 0 ? words.beyond : "before") + " the " + words.low_side;
}

DrivenFeeds feeds_of_moves(const Toolpath& toolpath, int workingstep,
                           const std::function<bool(const Move&)>& counts) {
  DrivenFeeds feeds;
  for (const Section& section : toolpath.sections) {
    if (section.workingstep != workingstep) continue;
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind) || !counts(move)) continue;
      feeds.low = std::min(feeds.low, move.feed.mm_per_min());
      feeds.high = std::max(feeds.high, move.feed.mm_per_min());
    }
  }
  return feeds;
}

}  // namespace

DrivenFeeds feeds_of_cuts(const Toolpath& toolpath, int workingstep) {
  return feeds_of_moves(toolpath, workingstep,
                        [](const Move& move) { return move.kind == MoveKind::kCut && !move.is_vertical(); });
}

DrivenFeeds feeds_of_plunges(const Toolpath& toolpath, int workingstep) {
  return feeds_of_moves(toolpath, workingstep,
                        [](const Move& move) { return move.is_vertical() && move.z_to < move.z_from; });
}

std::string speeds_of(const Toolpath& toolpath, int workingstep) {
  std::set<long long> speeds;
  for (const Section& section : toolpath.sections)
    if (section.workingstep == workingstep && section.spindle_rpm > 0)
      speeds.insert(std::llround(section.spindle_rpm));
  std::string text;
  for (const long long speed : speeds) text += (text.empty() ? "" : ", ") + std::to_string(speed);
  return text;
}

Extents extents_of(const Toolpath& toolpath, bool with_rapids) {
  Extents extents;
  extents.low = std::numeric_limits<double>::infinity();
  extents.high = -extents.low;
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind) && !with_rapids) continue;
      extents.plan.add(move.path.box());
      extents.low = std::min({extents.low, move.z_from, move.z_to});
      extents.high = std::max({extents.high, move.z_from, move.z_to});
    }
  }
  return extents;
}

double stickout_of(const Part& part, const Toolpath& toolpath, int tool) {
  double low = part.top_z();
  for (const Section& section : toolpath.sections) {
    if (section.tool_number != tool) continue;
    for (const Move& move : section.moves) low = std::min({low, move.z_from, move.z_to});
  }
  return std::ceil(part.top_z() - low + kAboveTop);
}

std::vector<int> tools_called(const Toolpath& toolpath) {
  std::vector<int> numbers;
  for (const Section& section : toolpath.sections) {
    if (std::find(numbers.begin(), numbers.end(), section.tool_number) == numbers.end())
      numbers.push_back(section.tool_number);
  }
  return numbers;
}

int tool_changes(const Toolpath& toolpath) {
  int changes = 0;
  for (std::size_t i = 1; i < toolpath.sections.size(); ++i)
    changes += toolpath.sections[i].tool_number != toolpath.sections[i - 1].tool_number ? 1 : 0;
  return changes;
}

std::string coolant_of_tool(const Toolpath& toolpath, int tool) {
  std::vector<Coolant> used;
  for (const Section& section : toolpath.sections) {
    const bool known = std::find(used.begin(), used.end(), section.coolant) != used.end();
    if (section.tool_number == tool && feed_length(section) > 0 && !known) used.push_back(section.coolant);
  }
  std::string text;
  for (const Coolant one : used)
    text += (text.empty() ? "" : ", ") + (one == Coolant::kBoth ? "flood and mist" : name_of(one));
  return text;
}

double time_of_tool(const Findings& findings, int tool) {
  double seconds = 0;
  for (const FeatureFindings& one : findings.features)
    seconds += one.tool_number == tool ? one.figures.time_s : 0;
  return seconds;
}

std::vector<FeatureFindings> in_order_of_cutting(const Findings& findings, const Toolpath& toolpath) {
  std::map<int, std::size_t> places;  // place of the first section of each workingstep
  for (const Section& section : toolpath.sections) places.emplace(section.workingstep, places.size());
  std::vector<FeatureFindings> rows;
  for (const FeatureFindings& one : findings.features)
    if (one.workingstep >= 0) rows.push_back(one);
  const auto place = [&](const FeatureFindings& one) {
    const auto found = places.find(one.workingstep);
    return found == places.end() ? toolpath.sections.size() + 1 : found->second;
  };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const FeatureFindings& a, const FeatureFindings& b) { return place(a) < place(b); });
  return rows;
}

std::string angle_of(const Tool& tool) {
  if (!has_flanks(tool)) return "";
  const double degrees = tool.tip_angle->degrees();
  return tool.kind == ToolKind::kTapered ? " " + trimmed(degrees / 2, 2) + " degrees a side"
                                         : " " + trimmed(degrees, 2) + " degrees";
}

std::string zero_on(const Stock& stock, double unit_mm, const std::string& unit) {
  const Box& plan = stock.plan;
  return "X: " + between(plan.min.x, plan.max.x, kAlongX, unit_mm, unit) +
         "; Y: " + between(plan.min.y, plan.max.y, kAlongY, unit_mm, unit) +
         "; Z: " + between(stock.z_bottom, stock.z_top, kAlongZ, unit_mm, unit);
}

}  // namespace clearcut::report
