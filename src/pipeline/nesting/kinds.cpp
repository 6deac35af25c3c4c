#include "pipeline/nesting/kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "options/copies_options.h"
#include "options/value.h"
#include "resolve/resolve.h"

namespace clearcut::pipeline {
namespace {

/// Clamps on a sheet to fill are in its coordinates, not in those of the part that is planned.
std::vector<KeepOut> take_clamps(Part& part, PlanOptions& options) {
  std::vector<KeepOut> clamps = std::move(part.keep_outs);
  clamps.insert(clamps.end(), options.keep_outs.begin(), options.keep_outs.end());
  part.keep_outs.clear();
  options.keep_outs.clear();
  return clamps;
}

/// Whether they cut alike, whatever they are called.
bool is_same_tool(const Tool& a, const Tool& b) {
  const auto shape = [](const Tool& t) {
    return std::tie(t.kind, t.diameter, t.corner_radius, t.teeth, t.flute_length, t.max_spindle_rpm,
                    t.center_cutting, t.tip_diameter, t.pitch, t.left_hand, t.floating, t.stickout,
                    t.holder_diameter, t.shank_diameter, t.high_speed_steel, t.coated);
  };
  const auto tip = [](const Tool& t) { return t.tip_angle ? t.tip_angle->radians() : -1; };
  return shape(a) == shape(b) && tip(a) == tip(b);
}

/// The tools of all kinds that have tools of their own, and what is stated of them.
class SharedTools {
 public:
  /// Places of the tools of `kind` in the table. A number that another tool has is given up for one that is free, which is said.
  std::vector<int> add(Kind& kind) {
    std::vector<int> places;
    resolve::number_tools(kind.part.tools);
    for (std::size_t i = 0; i < kind.part.tools.size(); ++i) {
      places.push_back(place_of(kind.part.tools[i], kind));
      const auto& cutting = kind.options.tool_cutting;
      if (i < cutting.size() && !cutting_[static_cast<std::size_t>(places.back())].stated)
        cutting_[static_cast<std::size_t>(places.back())] = cutting[i];
    }
    return places;
  }
  const std::vector<Tool>& tools() const { return tools_; }
  const std::vector<ToolCutting>& cutting() const { return cutting_; }

 private:
  int place_of(const Tool& tool, Kind& kind) {
    const auto same =
        std::find_if(tools_.begin(), tools_.end(), [&](const Tool& one) { return is_same_tool(one, tool); });
    if (same != tools_.end()) {
      tell(kind, tool, same->number);
      return static_cast<int>(same - tools_.begin());
    }
    tools_.push_back(tool);
    cutting_.emplace_back();
    if (!numbers_.insert(tool.number).second) {
      tools_.back().number = *numbers_.rbegin() + 1;
      numbers_.insert(tools_.back().number);
    }
    tell(kind, tool, tools_.back().number);
    return static_cast<int>(tools_.size()) - 1;
  }
  static void tell(Kind& kind, const Tool& tool, int number) {
    if (tool.number != number)
      kind.part.diagnostics.note(
          kind.name, fmt::format("T{} of this file is T{} of the sheet, whose kinds share one table of tools",
                                 tool.number, number));
  }

  std::vector<Tool> tools_;
  std::vector<ToolCutting> cutting_;
  std::set<int> numbers_;
};

/// One table of tools for all kinds, where these are not given.
void share_tools(Kinds& kinds) {
  if (!kinds.front().options.tools.empty()) return;
  SharedTools shared;
  for (Kind& kind : kinds) {
    const std::vector<int> places = shared.add(kind);
    for (Workingstep& step : kind.part.workplan)
      if (const auto tool = static_cast<std::size_t>(step.operation.tool); tool < places.size())
        step.operation.tool = places[tool];
  }
  for (Kind& kind : kinds) {
    if (kind.part.tools.empty()) continue;
    kind.part.tools = shared.tools();
    kind.options.tool_cutting = shared.cutting();
  }
}

/// Of the block, else of what is cut out; absent where nothing says how thick the material is.
std::optional<double> underside_of(const Part& part) {
  if (part.stock) return part.stock->z_bottom;
  std::optional<double> lowest;
  for (const Feature& feature : part.features)
    if (is_cut_out(feature))
      lowest = std::min(lowest.value_or(kLongestLength), feature.floor_z + feature.profile->beyond);
  return lowest;
}

/// Throws InputError for parts that do not lie in one sheet; all rapids are as high as those of the highest.
void share_heights(Kinds& kinds) {
  const Part& first = kinds.front().part;
  std::optional<double> clearance;
  std::optional<double> bottom;
  for (const Kind& kind : kinds) {
    if (std::abs(kind.part.top_z() - first.top_z()) > kSamePlaceMm)
      throw InputError(
          kind.name,
          fmt::format("begins at Z {} and {} at Z {}; parts of one sheet have one top",
                      trimmed(kind.part.top_z(), 3), kinds.front().name, trimmed(first.top_z(), 3)));
    if (kind.part.clearance_z)
      clearance = std::max(clearance.value_or(*kind.part.clearance_z), *kind.part.clearance_z);
    const std::optional<double> own = underside_of(kind.part);
    if (bottom && own && std::abs(*bottom - *own) > kSamePlaceMm)
      throw InputError(
          kind.name,
          fmt::format("is of material down to Z {}, others to Z {}; parts of one sheet are of one thickness",
                      trimmed(*own, 3), trimmed(*bottom, 3)));
    if (own) bottom = own;
  }
  if (!clearance) return;
  for (Kind& kind : kinds) clearance = std::max(*clearance, kind.part.safe_z());
  for (Kind& kind : kinds) kind.part.clearance_z = clearance;
}

std::string file_name_of(const std::string& path) {
  return path.substr(path.find_last_of("/\\") + 1);
}

/// The file that was asked for: of a job not its drawing.
std::string name_of_nested(const PlanOptions& options, std::size_t index) {
  const auto& with = options.copies.with;
  const auto asked = index < with.size() ? nested_file(with[index]) : std::nullopt;
  return file_name_of(asked ? asked->file : options.nested[index].part.source_file);
}

}  // namespace

bool is_cut_out(const Feature& feature) {
  return feature.profile && feature.profile->closed && feature.profile->side == ProfileSide::kOutside;
}

Kinds kinds_of(const Part& part, const PlanOptions& options, std::vector<KeepOut>& clamps) {
  Kinds kinds;
  kinds.push_back({file_name_of(part.source_file), part, options, options.copies.count});
  if (options.copies.sheet) clamps = take_clamps(kinds.front().part, kinds.front().options);
  if (options.nested.empty()) return kinds;
  // An option may serve only some of the kinds.
  kinds.front().options.refuse_idle = false;
  for (std::size_t i = 0; i < options.nested.size(); ++i) {
    const NestedPart& nested = options.nested[i];
    Kind kind{name_of_nested(options, i), nested.part, kinds.front().options, nested.count};
    if (!kind.part.keep_outs.empty())
      throw InputError(kind.name,
                       "states clamps, which are those of the sheet; state them with the first part");
    if (options.tools.empty()) kind.options.tool_cutting = nested.tool_cutting;
    kind.options.step_sources = nested.step_sources;
    kind.options.step_published = nested.step_published;
    kinds.push_back(std::move(kind));
  }
  share_tools(kinds);
  share_heights(kinds);
  return kinds;
}

}  // namespace clearcut::pipeline
