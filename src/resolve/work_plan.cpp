#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "base/units.h"
#include "features/round_hole.h"
#include "features/tool_choice.h"
#include "geometry/contours/boolean.h"
#include "model/cutter_profile.h"
#include "resolve/features/shaping.h"
#include "resolve/resolve.h"
#include "resolve/unreached.h"
#include "resolve/values/cutting_values.h"

namespace clearcut::resolve {
namespace {

constexpr double kWallStock = 0.3;   // mm; default
constexpr double kFloorStock = 0.2;  // mm
constexpr double kWearRange = 0.1;   // mm; default
constexpr const char* kForFinishing = "stock for the finishing steps on top";
/// Size of leads as a share of the cutter's radius.
constexpr double kLead = 0.5;
/// Degrees between the pass and lines along which compensation begins and ends.
constexpr double kLeadAngle = 45;

/// mm between the flat of a mill's end and the walls: below the rounding, material remains on floors along the walls.
double rounded_off(const Tool& tool) {
  return std::max(0.0, tool.radius() - flat_end(tool));
}

/// Whether `tool` reaches material left by `other`: in corners if narrower, or along floors if less rounded.
bool reaches_more(const Tool& tool, const Tool& other) {
  if (tool.diameter != other.diameter) return tool.diameter < other.diameter;
  return rounded_off(tool) < rounded_off(other);
}

/// Indices of the mills, in ascending order of reach, only the first of each shape.
std::vector<int> mills_of(const std::vector<Tool>& tools) {
  std::vector<int> mills;
  const auto at = [&](int i) -> const Tool& { return tools[static_cast<std::size_t>(i)]; };
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const auto is_alike = [&](int other) {
      return !reaches_more(tools[i], at(other)) && !reaches_more(at(other), tools[i]);
    };
    if (clears_floors(tools[i]) && std::none_of(mills.begin(), mills.end(), is_alike))
      mills.push_back(static_cast<int>(i));
  }
  std::stable_sort(mills.begin(), mills.end(), [&](int a, int b) { return reaches_more(at(b), at(a)); });
  return mills;
}

/// The last milling step of each feature, in the order of the workplan.
std::vector<Workingstep> last_milling_steps(const Part& part) {
  std::vector<Workingstep> last;
  for (const Workingstep& step : part.workplan) {
    const Feature& feature = feature_of(part, step);
    if (!clears_floors(tool_of(part, step)) || feature.carving || is_carved(feature, tool_of(part, step)))
      continue;
    std::erase_if(last, [&](const Workingstep& other) { return other.feature == step.feature; });
    last.push_back(step);
  }
  return last;
}

/// Whether narrower mills cut the material left by the step. `is_over_another`: another step is below it.
bool has_rest_steps(const Part& part, const Workingstep& step, bool is_over_another,
                    const PlanOptions& options) {
  const Feature& feature = feature_of(part, step);
  if (feature.profile) return false;  // a kerf is as wide as its cutter
  if (options.shop.rest.value_or(false)) return true;
  return is_over_another && step.operation.is_tool_chosen && feature.wall_slope.radians() == 0;
}

/// Whether `tool` reaches more than some cutter used on the feature of `step`, and is not used on it itself.
bool reaches_more_than_before(const Part& part, const Workingstep& step, const Tool& tool) {
  const bool is_used = std::any_of(part.workplan.begin(), part.workplan.end(), [&](const Workingstep& other) {
    return other.feature == step.feature && &tool_of(part, other) == &tool;
  });
  return !is_used && std::any_of(part.workplan.begin(), part.workplan.end(), [&](const Workingstep& other) {
    return other.feature == step.feature && clears_floors(tool_of(part, other)) &&
           reaches_more(tool, tool_of(part, other));
  });
}

Workingstep named_step(const Workingstep& step, const std::string& ending, OperationKind kind,
                       StepSources& sources) {
  Workingstep out = step;
  out.stated_path.reset();
  out.name += ending;
  sources[step_key(out)] = sources[step_key(step)];
  out.operation.name = out.name;
  out.operation.kind = kind;
  out.operation.rest = false;
  return out;
}

double wall_stock_of(const ShopOptions& shop) {
  return shop.finish_stock.value_or(kWallStock);
}

/// Leads into and out of passes along walls. A control begins and ends compensation along lines; in the slot of a profile there is
/// room for lines that begin where the cutter cut the slot.
void add_lead(Operation& operation, const Feature& feature, const Tool& tool, const ShopOptions& shop,
              Sources& sources) {
  const bool in_slot = feature.profile && !operation.lead;
  if ((writes_wear(shop) || in_slot) && !operation.lead_angle) {
    operation.lead_angle = Radians::of_degrees(kLeadAngle);
    sources.set("lead-angle", {Origin::kDerived, in_slot ? "the slot has no room for arcs"
                                                         : "compensation begins along lines"});
  }
  if (operation.lead) return;
  operation.lead =
      in_slot ? wall_stock_of(shop) / base::sin(operation.lead_angle->radians()) : kLead * tool.radius();
  sources.set("lead",
              {Origin::kDerived, in_slot ? "from where the slot was cut" : "half the cutter's radius"});
}

/// Along the walls, with the tool that came last.
Workingstep wall_step(const Workingstep& last, const std::string& ending, const Part& part,
                      const ShopOptions& shop, StepSources& sources) {
  Workingstep step = named_step(last, ending, OperationKind::kSideFinishing, sources);
  Operation& operation = step.operation;
  const Feature& feature = feature_of(part, last);
  const double depth = feature.top_z - feature.floor_z - operation.allowance_floor;
  // Drafted walls are cut by the edges of layers: one pass at their foot would leave them.
  const bool leans = feature.wall_slope.radians() != 0;
  if (depth > 0 && !leans) {
    operation.stepdown = depth / shop.finish_depths.value_or(1);
    sources[step_key(step)].set("stepdown", {Origin::kDerived, "the depth over the depths of finishing"});
  }
  add_lead(operation, feature, tool_of(part, last), shop, sources[step_key(step)]);
  return step;
}

/// The passes beside each other in which the walls of a feature come to size, and those that are run again then.
void add_wall_steps(const Workingstep& last, const Part& part, const ShopOptions& shop,
                    std::vector<Workingstep>& walls, StepSources& sources) {
  const int steps = static_cast<int>(shop.finish_steps.value_or(1));
  const int springs = static_cast<int>(shop.spring_passes.value_or(0));
  const double stock = wall_stock_of(shop);
  for (int k = 1; k < steps; ++k) {
    Workingstep step = wall_step(last, "_walls_" + std::to_string(k), part, shop, sources);
    step.operation.allowance_side += stock * (steps - k) / steps;
    sources[step_key(step)].set("allowance", {Origin::kDerived, "stock for the passes beside it"});
    walls.push_back(std::move(step));
  }
  walls.push_back(wall_step(last, "_walls", part, shop, sources));
  for (int k = 1; k <= springs; ++k)
    walls.push_back(wall_step(last, "_walls_spring" + (k > 1 ? "_" + std::to_string(k) : std::string()), part,
                              shop, sources));
}

/// The slot of a followed line is as wide as its cutter: it has no walls to be finished.
bool has_walls(const Feature& feature) {
  return !feature.profile || feature.profile->side != ProfileSide::kOn;
}

/// The step that finishes a floor with the tool of `roughing`: the whole floor, or with `rest` the material that wider tools left
/// of it. It keeps a distance from walls that are finished afterwards.
Workingstep floor_step(const Workingstep& roughing, bool rest, const Part& part, const ShopOptions& shop,
                       StepSources& sources) {
  Workingstep step = named_step(roughing, "_floor", OperationKind::kBottomFinishing, sources);
  step.operation.rest = rest;
  if (finish_of(shop) == Finish::kAll && has_walls(feature_of(part, roughing))) {
    step.operation.allowance_side += wall_stock_of(shop);
    sources[step_key(step)].set("allowance", {Origin::kDerived, kForFinishing});
  }
  return step;
}

/// The floor of a feature with its first mill, then with every mill of greater reach.
void add_floor_steps(const Part& part, int feature, const ShopOptions& shop, std::vector<Workingstep>& floors,
                     StepSources& sources) {
  const Tool* before = nullptr;
  for (const Workingstep& step : part.workplan) {
    const Tool& tool = tool_of(part, step);
    if (step.feature != feature || !clears_floors(tool) || (before && !reaches_more(tool, *before))) continue;
    floors.push_back(floor_step(step, before != nullptr, part, shop, sources));
    before = &tool;
  }
}

void leave_stock(Operation& operation, const Feature& feature, const ShopOptions& shop, Sources& sources) {
  const Finish finish = finish_of(shop);
  if (finish != Finish::kFloor && has_walls(feature)) {
    operation.allowance_side += wall_stock_of(shop);
    sources.set("allowance", {Origin::kDerived, kForFinishing});
  }
  if (finish != Finish::kWalls) {
    operation.allowance_floor += shop.finish_stock_floor.value_or(kFloorStock);
    sources.set("allowance-floor", {Origin::kDerived, kForFinishing});
  }
}

Workingstep rest_step(const Workingstep& step, int mill, const Part& part, const PlanOptions& options,
                      StepSources& sources) {
  const Tool& tool = part.tools[static_cast<std::size_t>(mill)];
  Workingstep rest = step;
  rest.stated_path.reset();
  change_tool(rest.operation, mill, part, options);
  rest.name += "_rest_T" + std::to_string(tool.number);
  rest.operation.name = rest.name;
  sources[step_key(rest)] = sources[step_key(step)];
  sources[step_key(rest)].set("tool", {Origin::kDerived, "a narrower cutter for what is left"});
  rest.operation.rest = true;
  return rest;
}

/// Position in the workplan of the first step behind the first one on the feature of `step` whose own feature is as wanted.
template <typename Wanted>
std::optional<std::size_t> first_later(const Part& part, const Workingstep& step, const Wanted& is_wanted) {
  bool later = false;
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    if (later && is_wanted(feature_of(part, part.workplan[i]))) return i;
    later = later || part.workplan[i].feature == step.feature;
  }
  return std::nullopt;
}

/// The first later step on a feature below that of `step`: material left by `step` would remain over it.
std::optional<std::size_t> first_step_under(const Part& part, const Workingstep& step,
                                            const Tolerances& tol) {
  const Feature& feature = feature_of(part, step);
  return first_later(part, step, [&](const Feature& other) {
    return other.floor_z < feature.floor_z && !intersect(other.target, feature.target, tol).empty();
  });
}

/// mm. A chamfer's line this near to a wall is along its edge.
constexpr double kAlongEdge = 0.01;

/// The first later step that breaks an edge of the feature: its tip goes where the material beside the edge must be gone.
std::optional<std::size_t> first_chamfer_of(const Part& part, const Workingstep& step) {
  const Feature& feature = feature_of(part, step);
  const Box around = box(feature.target).grown(kAlongEdge);
  const std::vector<Edge> walls = edges_of(feature.target);
  const auto is_on_wall = [&](const Edge& edge) {
    const Vec2 middle = edge.at(0.5);
    return around.contains(middle) && std::any_of(walls.begin(), walls.end(), [&](const Edge& wall) {
             return distance(wall, middle) <= kAlongEdge;
           });
  };
  return first_later(part, step, [&](const Feature& other) {
    return other.chamfer && std::any_of(other.chamfer->line.begin(), other.chamfer->line.end(), is_on_wall);
  });
}

}  // namespace

Finish finish_of(const ShopOptions& shop) {
  if (!shop.finish) return Finish::kNone;
  if (*shop.finish == "walls") return Finish::kWalls;
  if (*shop.finish == "floor") return Finish::kFloor;
  if (*shop.finish == "all") return Finish::kAll;
  throw InputError("finish", "'" + *shop.finish + "' is unknown; use one of walls, floor, all");
}

bool writes_wear(const ShopOptions& shop) {
  return shop.compensation == "wear";
}

double wear_range_of(const ShopOptions& shop) {
  return shop.wear_range.value_or(kWearRange);
}

namespace {

/// Whether the ball or bull-nose that makes the fillet between floor and walls is better preceded by the mill: it leaves cusps on the floor,
/// or is narrower.
bool roughs_for(const Tool& mill, const Tool& finisher, const Feature& feature) {
  if (!clears_floors(mill) || flat_end(mill) <= 0 || mill.kind == ToolKind::kTapered) return false;
  if (features::keeps_fillet(mill, feature)) return false;
  return flat_end(finisher) <= 0 || mill.diameter > finisher.diameter;
}

/// The widest mill that roughs a feature whose fillet `finisher` makes, off the walls by the fillet; -1 if there is none.
int roughing_mill(const Part& part, const Feature& feature, const Tool& finisher, const Tolerances& tol) {
  const double fits = features::largest_fitting_diameter(feature, tol) - 2 * feature.floor_fillet;
  int widest = -1;
  for (std::size_t i = 0; i < part.tools.size(); ++i) {
    const Tool& tool = part.tools[i];
    if (!roughs_for(tool, finisher, feature) || tool.diameter > fits || !reaches_floor(part, feature, tool) ||
        !features::has_room_to_enter(feature, tool, tol))
      continue;
    if (widest < 0 || tool.diameter > part.tools[static_cast<std::size_t>(widest)].diameter)
      widest = static_cast<int>(i);
  }
  return widest;
}

/// Puts a mill with a flat end before the tool of a fillet between floor and walls, which then cuts what the mill has left.
void rough_before_fillets(Part& part, const PlanOptions& options, StepSources& sources) {
  std::vector<Workingstep> all;
  for (const Workingstep& step : part.workplan) {
    const Feature& feature = feature_of(part, step);
    const bool is_filleted = feature.floor_fillet > 0 && step.operation.is_tool_chosen && !feature.profile &&
                             features::makes_fillet(tool_of(part, step), feature);
    const int mill = is_filleted ? roughing_mill(part, feature, tool_of(part, step), options.tol) : -1;
    if (mill < 0) {
      all.push_back(step);
      continue;
    }
    Workingstep rough = step;
    change_tool(rough.operation, mill, part, options);
    sources[step_key(rough)].set("tool", {Origin::kDerived, "a flat end before the tool of the fillet"});
    all.push_back(rough);
    all.push_back(rest_step(rough, step.operation.tool, part, options, sources));
  }
  part.workplan = std::move(all);
}

/// Whether a mill bores the hole for a tap, a reamer, a boring bar or a thread mill, which finishes it.
bool comes_before_another_tool(const Feature& feature) {
  return feature.hole && feature.hole->kind == HoleKind::kDrilled;
}

}  // namespace

void add_rest_steps(Part& part, const PlanOptions& options, StepSources& sources) {
  rough_before_fillets(part, options, sources);
  std::vector<std::vector<Workingstep>> before(part.workplan.size());
  std::vector<std::pair<int, Workingstep>> at_end;  // steps at the end by mill, widest first
  const auto mills = mills_of(part.tools);
  if (mills.size() < 2) return;
  for (const Workingstep& step : last_milling_steps(part)) {
    const auto under = first_step_under(part, step, options.tol);
    if (!has_rest_steps(part, step, under.has_value(), options)) continue;
    const auto chamfer = first_chamfer_of(part, step);
    const auto next = under && chamfer ? std::min(under, chamfer) : under ? under : chamfer;
    const double fits =
        features::largest_fitting_diameter(feature_of(part, step), options.tol) + options.tol.fit;
    for (std::size_t i = 0; i < mills.size(); ++i) {
      const Tool& tool = part.tools[static_cast<std::size_t>(mills[i])];
      if (tool.diameter > fits || !features::keeps_walls(tool, feature_of(part, step)) ||
          !features::keeps_fillet(tool, feature_of(part, step)) ||
          meets_steeper_walls(part, feature_of(part, step), tool, options.tol) ||
          !reaches_more_than_before(part, step, tool))
        continue;
      if (next) {
        before[*next].push_back(rest_step(step, mills[i], part, options, sources));
      } else {
        at_end.emplace_back(static_cast<int>(i), rest_step(step, mills[i], part, options, sources));
      }
    }
  }
  std::stable_sort(at_end.begin(), at_end.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Workingstep> all;
  for (std::size_t i = 0; i < before.size(); ++i) {
    all.insert(all.end(), before[i].begin(), before[i].end());
    all.push_back(part.workplan[i]);
  }
  for (const auto& [mill, step] : at_end) all.push_back(step);
  std::set<std::string> rests;
  for (const auto& [mill, step] : at_end) rests.insert(step.name);
  for (const auto& steps : before)
    for (const Workingstep& step : steps) rests.insert(step.name);
  part.workplan = std::move(all);
  drop_unreached_rests(part, rests, options.tol);
}

void add_finishing_steps(Part& part, const PlanOptions& options, StepSources& sources) {
  const ShopOptions& shop = options.shop;
  const Finish finish = finish_of(shop);
  std::vector<Workingstep> floors, walls;
  for (const Workingstep& last : last_milling_steps(part)) {
    if (comes_before_another_tool(feature_of(part, last))) continue;
    const auto hole = features::round_hole_of(feature_of(part, last), options.tol);
    if (hole && features::makes_hole(tool_of(part, last), *hole, options.tol)) continue;
    if (finish != Finish::kWalls) add_floor_steps(part, last.feature, shop, floors, sources);
    if (finish != Finish::kFloor && has_walls(feature_of(part, last)))
      add_wall_steps(last, part, shop, walls, sources);
  }
  for (Workingstep& step : part.workplan) {
    const auto same = [&](const Workingstep& other) { return other.feature == step.feature; };
    const bool finished =
        std::any_of(floors.begin(), floors.end(), same) || std::any_of(walls.begin(), walls.end(), same);
    if (finished && clears_floors(tool_of(part, step)))
      leave_stock(step.operation, feature_of(part, step), shop, sources[step_key(step)]);
  }
  part.workplan.insert(part.workplan.end(), floors.begin(), floors.end());
  part.workplan.insert(part.workplan.end(), walls.begin(), walls.end());
  // A thread about a boss is milled where the boss has its finished width, and the disc of a T-slot goes down where a pocket or the neck
  // has its finished width and floor.
  std::stable_partition(part.workplan.begin(), part.workplan.end(), [&](const Workingstep& step) {
    const FeatureKind kind = feature_of(part, step).kind;
    return kind != FeatureKind::kExternalThread && kind != FeatureKind::kTSlot;
  });
}

}  // namespace clearcut::resolve
