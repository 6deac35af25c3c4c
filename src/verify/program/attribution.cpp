#include "verify/program/attribution.h"

#include <algorithm>

namespace clearcut::verify {
namespace {

/// mm. A tip no farther than this below a feature's floor still counts as inside its range of heights.
constexpr double kHeightSlack = 0.05;
/// mm. Rounding error of a path that just touches an outline.
constexpr double kJustTouches = 1e-3;

Vec2 middle_of(const Move& move) {
  return move.is_vertical() ? move.path.from : move.path.at(0.5);
}

}  // namespace

Attribution::Attribution(const Part& part) : part_(part), names_(part) {
  for (const Feature& feature : part.features) {
    std::vector<Edge> edges;
    for (const Region& region : feature.target) {
      for (const Edge& edge : region.edges()) edges.push_back(edge);
    }
    outlines_.emplace_back(std::move(edges));
  }
}

int Attribution::by_section(const Section& section) const {
  return names_.workingstep_of(section);
}

int Attribution::by_place(const CheckedMove& checked, int previous) const {
  const Vec2 middle = middle_of(*checked.move);
  if (previous >= 0 && fits(checked, middle, previous)) return previous;
  int found = -1;
  for (int i = 0; i < static_cast<int>(part_.workplan.size()); ++i) {
    if (fits(checked, middle, i) && (found < 0 || has_tool(checked, i))) found = i;
  }
  return found;
}

std::optional<double> Attribution::stepdown_at(const CheckedMove& checked) const {
  const Vec2 middle = middle_of(*checked.move);
  std::optional<double> of_tool, of_any;
  for (int i = 0; i < static_cast<int>(part_.workplan.size()); ++i) {
    const std::optional<double> stepdown = part_.workplan[i].operation.stepdown;
    // The tip of a cone goes below the foot of the chamfer cut by its flank.
    const bool chamfers = i == checked.workingstep && feature_of(part_, part_.workplan[i]).chamfer;
    if (!chamfers && !fits(checked, middle, i, checked.radius())) continue;
    if (!stepdown) {
      if (has_tool(checked, i)) return std::nullopt;  // this step of the tool has no limit
      continue;
    }
    of_any = std::max(of_any.value_or(0), *stepdown);
    if (has_tool(checked, i)) of_tool = std::max(of_tool.value_or(0), *stepdown);
  }
  // Values of other tools do not apply to a tool of an earlier program.
  return of_tool || checked.earlier ? of_tool : of_any;
}

bool Attribution::has_tool(const CheckedMove& checked, int workingstep) const {
  const int index = part_.workplan[workingstep].operation.tool;
  return checked.tool && index >= 0 && index < static_cast<int>(part_.tools.size()) &&
         part_.tools[index].number == checked.tool->number;
}

bool Attribution::fits(const CheckedMove& checked, Vec2 p, int workingstep, double beside) const {
  const int index = part_.workplan[workingstep].feature;
  const Feature& feature = part_.features[index];
  const double z = checked.low_z();
  if (z < feature.floor_z - kHeightSlack || z >= feature.top_z - 1e-6) return false;
  const EdgeTree& outline = outlines_[index];
  // Over open sides and at thin ends the centre runs beside the target.
  return outline.winding(p) != 0 || outline.nearest(p, checked.radius() + beside + kJustTouches).edge >= 0;
}

}  // namespace clearcut::verify
