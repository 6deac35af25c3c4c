#include <algorithm>
#include <utility>

#include "base/text.h"
#include "geometry/contours/boolean.h"
#include "geometry/spatial/cell_grid.h"
#include "read/board/drawn.h"
#include "read/board/excellon_reader.h"
#include "read/drawing/stroke.h"
#include "read/repair/clean.h"

namespace clearcut::read {
namespace {

std::string name_of(int number, double diameter) {
  return "T" + std::to_string(number) + " " + trimmed(diameter, 4) + " mm";
}

std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + (count == 1 ? " hole " : " holes ") + what;
}

/// The holes of a tool, sorted out.
struct SortedHoles {
  std::vector<Vec2> alone, overlapping;
};

class HoleSorter {
 public:
  HoleSorter(const DrillTool& tool, const Tolerances& tol) : tool_(tool), tol_(tol), index_(tool.diameter) {
    for (const Vec2 hole : tool.holes) {
      if (any_near(hole, [&](Vec2 other) { return distance(hole, other) <= tol_.join_gap; })) continue;
      index_.add(hole, static_cast<std::uint32_t>(once_.size()));
      once_.push_back(hole);
    }
  }

  std::size_t twice() const { return tool_.holes.size() - once_.size(); }

  SortedHoles sorted() const {
    SortedHoles sorted;
    for (const Vec2 hole : once_) (overlaps(hole) ? sorted.overlapping : sorted.alone).push_back(hole);
    return sorted;
  }

 private:
  template <typename Is>
  bool any_near(Vec2 hole, Is is) const {
    const std::vector<std::uint32_t> near = index_.near(hole);
    return std::any_of(near.begin(), near.end(), [&](std::uint32_t i) { return is(once_[i]); });
  }

  bool overlaps(Vec2 hole) const {
    const double touching = tool_.diameter - tol_.coincident;
    const auto is_other = [&](Vec2 other) { return other != hole && distance(hole, other) < touching; };
    return any_near(hole, is_other) ||
           std::any_of(tool_.slots.begin(), tool_.slots.end(), [&](const Path& slot) {
             return std::any_of(slot.begin(), slot.end(),
                                [&](const Edge& edge) { return distance(edge, hole) < touching; });
           });
  }

  const DrillTool& tool_;
  const Tolerances& tol_;
  BoxIndex index_;
  std::vector<Vec2> once_;
};

/// Edges followed by the centres of wider tools, each with the distance up to which holes of a diameter are inside
/// the slot.
std::vector<std::pair<Edge, double>> wider_slots(const std::map<int, DrillTool>& tools, double diameter) {
  std::vector<std::pair<Edge, double>> wider;
  for (const auto& [number, tool] : tools) {
    if (tool.diameter <= diameter) continue;
    for (const Path& slot : tool.slots)
      for (const Edge& edge : slot) wider.emplace_back(edge, (tool.diameter - diameter) / 2);
  }
  return wider;
}

class ToolGroups {
 public:
  ToolGroups(int number, const DrillTool& tool, const std::string& file, const ReadOptions& options)
      : number_(number), tool_(tool), file_(file), options_(options) {}

  std::vector<DrawnGroup> made(const std::map<int, DrillTool>& tools, Diagnostics& diagnostics) const {
    const HoleSorter sorter(tool_, options_.tol);
    SortedHoles holes = sorter.sorted();
    const auto slots = wider_slots(tools, tool_.diameter);
    const std::size_t in_slots = std::erase_if(holes.alone, [&](Vec2 hole) {
      return std::any_of(slots.begin(), slots.end(),
                         [&](const auto& slot) { return distance(slot.first, hole) <= slot.second; });
    });
    const std::string where = file_ + ": " + name();
    if (sorter.twice() > 0) diagnostics.note(where, counted(sorter.twice(), "drilled twice count once"));
    if (in_slots > 0) diagnostics.note(where, counted(in_slots, "within slots of wider tools are left out"));
    if (!holes.overlapping.empty())
      diagnostics.note(where, counted(holes.overlapping.size(), "that overlap are milled as slots"));
    std::vector<DrawnGroup> groups{holes_at(holes.alone), slots_with(holes.overlapping)};
    std::erase_if(groups, [](const DrawnGroup& group) { return group.curves.empty(); });
    return groups;
  }

 private:
  double diameter() const { return tool_.diameter * options_.scale; }
  std::string name() const { return name_of(number_, diameter()); }

  DrawnGroup group_named(const std::string& name, LayerRole role) const {
    DrawnGroup group;
    group.name = name;
    group.where = file_ + ": " + name;
    group.role = role;
    group.says_role = true;
    apply_rules(options_.layer_rules, name, group);
    return group;
  }

  DrawnGroup holes_at(const std::vector<Vec2>& centers) const {
    DrawnGroup holes = group_named(name(), LayerRole::kHole);
    holes.hole = HoleRequest{};
    holes.hole->through = true;
    for (const Vec2 at : centers)
      holes.curves.push_back({full_circle(at * options_.scale, diameter() / 2), true, "a hole", {}});
    return holes;
  }

  DrawnGroup slots_with(const std::vector<Vec2>& holes) const {
    DrawnGroup slots = group_named(name() + " slot", LayerRole::kPocket);
    RepairOptions repair;
    repair.tol = options_.tol;
    repair.where = slots.where;
    const Pen pen{tool_.diameter, StrokeCap::kRound, StrokeJoin::kRound};
    std::vector<Drawn> drawn;
    for (const Path& line : tool_.slots) {
      drawn.push_back({true, stroke_pieces({{line, false}}, pen), {}});
      drawn.back() = mapped(drawn.back(), Affine::scaling(options_.scale, options_.scale));
    }
    for (const Vec2 at : holes)
      drawn.push_back({true, {full_circle(at * options_.scale, diameter() / 2)}, {}});
    for (Path& loop : loops_of(dark_area(drawn, repair)))
      slots.curves.push_back({std::move(loop), true, "a slot", {}});
    return slots;
  }

  int number_;
  const DrillTool& tool_;
  const std::string& file_;
  const ReadOptions& options_;
};

}  // namespace

std::vector<DrawnGroup> drilled_groups(const std::map<int, DrillTool>& tools, const std::string& file,
                                       const ReadOptions& options, Diagnostics& diagnostics) {
  std::vector<DrawnGroup> groups;
  for (const auto& [number, tool] : tools)
    for (DrawnGroup& group : ToolGroups(number, tool, file, options).made(tools, diagnostics))
      groups.push_back(std::move(group));
  return groups;
}

}  // namespace clearcut::read
