#include "pipeline/setups/carried_stock.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "base/text.h"
#include "features/standing.h"
#include "geometry/contours/boolean.h"
#include "model/results/nothing_to_machine.h"
#include "pipeline/setups/solid_stock.h"
#include "resolve/resolve.h"
#include "stock/material.h"

namespace clearcut::pipeline {
namespace {

/// mm. A hollow ending no more than this below the top of a feature reaches the top: programs have rounded digits.
constexpr double kThrough = 0.002;
/// mm; depth of through cuts below all cuts of a later set-up.
constexpr double kBelowAll = 1;
/// mm. Residual thickness permitted on a faced top.
constexpr double kFaced = 0.01;

/// Whether the tool cuts at its full width from some height above its tip on, and everything above.
bool is_cylinder(const Tool& tool) {
  switch (tool.kind) {
    case ToolKind::kEndMill:
    case ToolKind::kFaceMill:
    case ToolKind::kBallEndMill:
    case ToolKind::kBullNoseEndMill:
    case ToolKind::kDrill:
    case ToolKind::kCounterbore:
      return true;
    default:
      return false;
  }
}

/// mm above its tip at which a cylinder reaches its full width.
double end_of(const Tool& tool) {
  if (tool.kind == ToolKind::kDrill) return point_length(tool);
  return tool.kind == ToolKind::kBallEndMill ? tool.radius() : tool.corner_radius;
}

/// An empty section for the cuts of an earlier set-up by the tool of `section`.
Section carried(const Section& section, double below) {
  Section like;
  like.label = "earlier set-up";
  like.tool_number = section.tool_number;
  like.spindle_rpm = section.spindle_rpm;
  like.spindle_clockwise = section.spindle_clockwise;
  like.carried_below = below;
  return like;
}

template <typename Visit>
void for_cuts(const MachinedSetup& setup, Visit visit) {
  for (const Section& section : setup.toolpath.sections) {
    const Tool* tool = tool_numbered(setup.part.tools, section.tool_number);
    if (!tool || !is_cylinder(*tool)) continue;
    for (const Move& move : section.moves) {
      if (!is_rapid(move.kind)) visit(section, *tool, move);
    }
  }
}

/// Seen from the same side: each move unchanged.
Toolpath as_it_was(const MachinedSetup& setup, const SetupPlace& to) {
  Sweeps sweeps;
  for_cuts(setup, [&](const Section& section, const Tool& tool, Move move) {
    const double end = end_of(tool);
    move.path = moved(move.path, to);
    move.z_from = moved_z(move.z_from + end, to);
    move.z_to = moved_z(move.z_to + end, to);
    sweeps.add(carried(section, std::numeric_limits<double>::infinity()), move);
  });
  return sweeps.take();
}

/// Seen from below: each cut is a hollow with a ceiling, as if cut from this side except for the material above the
/// ceiling. For ramps the ceiling is at their higher end.
Toolpath hollows_of(const MachinedSetup& setup, const SetupPlace& to, const Part& next) {
  double low = next.stock ? next.stock->z_bottom : next.top_z(), lowest_top = next.top_z();
  for (const Feature& feature : next.features) {
    low = std::min(low, feature.floor_z);
    lowest_top = std::min(lowest_top, feature.top_z);
  }
  Sweeps sweeps;
  for_cuts(setup, [&](const Section& section, const Tool& tool, Move move) {
    const double highest =
        move.is_vertical() ? std::min(move.z_from, move.z_to) : std::max(move.z_from, move.z_to);
    const double ceiling = moved_z(highest + end_of(tool), to) + kThrough;
    if (ceiling < lowest_top) return;
    move.path = moved(move.path, to);
    move.z_from = move.z_to = low - kBelowAll;
    sweeps.add(carried(section, ceiling), move);
  });
  return sweeps.take();
}

/// The top of the block of a set-up after its program: lower if faced off completely.
double top_left(const MachinedSetup& setup, const Stock& block) {
  std::set<double> levels;
  std::vector<double> radii;
  for (const Tool& tool : setup.part.tools) radii.push_back(tool.radius());
  stock::Material material(block.plan, block.z_top, radii);
  for_cuts(setup, [&](const Section&, const Tool& tool, Move move) {
    move.z_from += end_of(tool);
    move.z_to += end_of(tool);
    material.add(move, tool.radius());
    if (move.z_from == move.z_to && move.z_to < block.z_top - kFaced && move.z_to > block.z_bottom)
      levels.insert(move.z_to);
  });
  const Vec2 middle = block.plan.center();
  const double half = block.plan.height() / 2;
  const Edge line = Edge::line({block.plan.min.x, middle.y}, {block.plan.max.x, middle.y});
  double top = block.z_top;
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
    if (material.in_reach(line, half, *level + kFaced)) break;
    top = *level;
  }
  return top;
}

/// With the number of the set-up before its sentence; its lines are those of another program.
template <typename Said>
void append_of_setup(std::size_t number, const std::vector<Said>& from, std::vector<Said>& to) {
  for (Said one : from) {
    one.text = "in the program of set-up " + std::to_string(number) + ": " + one.text;
    to.push_back(std::move(one));
  }
}

/// Text on one earlier set-up.
std::string told_of(std::size_t number, const SetupPlace& place, bool any) {
  const std::string whose = "of set-up " + std::to_string(number) + " ";
  if (!keeps_verticals(place))
    return whose + "only the block is carried: what it cut lies across and counts as solid";
  if (!turns_over(place)) return whose + "everything that mills and drills cut is carried";
  return whose + (any ? "what it cut through is carried; " : "nothing went through; ") +
         "hollows that lie under material count as solid";
}

}  // namespace

Part on_block(Part part, const Stock& left) {
  const std::optional<Stock> whole = std::exchange(part.stock, left);
  if (!whole) return part;
  const auto is_cut_away = [&](const Workingstep& step) {
    const Feature& feature = feature_of(part, step);
    return resolve::is_of_program(step) && feature.floor_z < whole->z_top - kSamePlaceMm &&
           feature.floor_z >= left.z_top - kSamePlaceMm;
  };
  std::size_t away = 0;
  for (const Workingstep& step : part.workplan) {
    if (!is_cut_away(step)) continue;
    const Feature& feature = feature_of(part, step);
    ++away;
    part.diagnostics.note(part.source_file, "workingstep " + step.source + " '" + step.name +
                                                "' has nothing left to cut: earlier set-ups have cut away " +
                                                feature.name + ", which ends at z " +
                                                trimmed(feature.floor_z, 3) + ", down to z " +
                                                trimmed(left.z_top, 3));
  }
  if (away == 0) return part;
  if (away == part.workplan.size())
    throw NothingToMachine(part.source_file, "earlier set-ups have cut away all that it would cut",
                           part.diagnostics, names_not_machined(part.diagnostics).empty());
  std::erase_if(part.workplan, is_cut_away);
  resolve::drop_unused_features(part);
  const std::vector<double> tops = features::stacked_tops(part, Tolerances{});
  for (const Workingstep& step : part.workplan) {
    const auto index = static_cast<std::size_t>(step.feature);
    part.features[index].top_z = std::min(part.features[index].top_z, tops[index]);
  }
  return part;
}

CarriedStock carried_stock(const std::vector<MachinedSetup>& earlier, const SetupPlace& place,
                           const Part& next) {
  CarriedStock out;
  Sweeps sweeps;
  Stock block = *earlier.front().part.stock;
  SetupPlace in = earlier.front().place;  // coordinates of `block`
  for (std::size_t i = 0; i < earlier.size(); ++i) {
    const MachinedSetup& setup = earlier[i];
    block = moved(block, between(in, setup.place));
    in = setup.place;
    const SetupPlace to = between(setup.place, place);
    Toolpath cut;
    if (keeps_verticals(to)) cut = turns_over(to) ? hollows_of(setup, to, next) : as_it_was(setup, to);
    out.told += (i ? "; " : "") + told_of(i + 1, to, !cut.sections.empty());
    sweeps.append(std::move(cut));
    block.z_top = top_left(setup, block);
  }
  out.block = moved(block, between(in, place));
  out.sweeps = sweeps.take();
  if (next.stock) out.conditions = meeting_floors(earlier, place, next, Tolerances{});
  for (std::size_t i = 0; i < earlier.size(); ++i) {
    append_of_setup(i + 1, earlier[i].conditions, out.conditions);
    append_of_setup(i + 1, earlier[i].faults, out.faults);
  }
  return out;
}

namespace {

/// mm by which floors must overlap, and mm2 over which, to count.
constexpr double kDeeper = 0.01;
constexpr double kOver = 1;

bool ends_in_the_block(const Feature& feature, const Stock& block) {
  return feature.floor_z > block.z_bottom + kDeeper;
}

Regions moved(const Regions& regions, const SetupPlace& place, const Tolerances& tol) {
  std::vector<Loop> loops;
  const auto add = [&](const Loop& loop) {
    Loop& out = loops.emplace_back();
    for (const Edge& edge : loop) out.push_back(model::moved(edge, place));
  };
  for (const Region& region : regions) {
    add(region.outer());
    for (const Loop& island : region.islands()) add(island);
  }
  return resolve_nonzero(loops, tol);
}

/// The features of `next` in the coordinates of one earlier set-up.
class FeaturesFromBelow {
 public:
  FeaturesFromBelow(const Part& next, const SetupPlace& to_earlier, const Tolerances& tol) : tol_(tol) {
    for (const Feature& feature : next.features) {
      if (!ends_in_the_block(feature, *next.stock)) continue;
      features_.push_back(
          {&feature, moved(feature.target, to_earlier, tol), moved_z(feature.floor_z, to_earlier)});
    }
  }

  void meet(const MachinedSetup& setup, std::size_t number, std::vector<Condition>& conditions) const {
    const Stock& block = *setup.part.stock;
    for (const Feature& above : setup.part.features) {
      if (!ends_in_the_block(above, block)) continue;
      for (const FromBelow& below : features_) {
        if (below.ceiling < above.floor_z + kDeeper || !box(below.target).overlaps(box(above.target)))
          continue;
        const double shared = area(intersect(above.target, below.target, tol_));
        if (shared <= kOver) continue;
        conditions.push_back({"floors-meet",
                              below.feature->name + " cuts the floor of " + above.name + " of set-up " +
                                  std::to_string(number) + " away: together they go " +
                                  trimmed(below.ceiling - above.floor_z, 3) +
                                  " mm deeper than the block is thick, over " + trimmed(shared, 1) + " mm2",
                              0,
                              {}});
      }
    }
  }

 private:
  struct FromBelow {
    const Feature* feature;
    Regions target;
    double ceiling;  ///< mm; its floor, seen from above
  };
  const Tolerances& tol_;
  std::vector<FromBelow> features_;
};

}  // namespace

std::vector<Condition> meeting_floors(const std::vector<MachinedSetup>& earlier, const SetupPlace& place,
                                      const Part& next, const Tolerances& tol) {
  std::vector<Condition> conditions;
  for (std::size_t i = 0; i < earlier.size(); ++i) {
    if (earlier[i].part.is_solid && next.is_solid) continue;
    const SetupPlace back = between(place, earlier[i].place);
    if (!keeps_verticals(back) || !turns_over(back)) continue;
    FeaturesFromBelow(next, back, tol).meet(earlier[i], i + 1, conditions);
  }
  return conditions;
}

}  // namespace clearcut::pipeline
