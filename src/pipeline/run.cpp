#include "pipeline/run.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "base/format.h"
#include "geometry/boolean.h"
#include "link/slot_feed.h"
#include "part/round_hole.h"
#include "pipeline/certify.h"
#include "pipeline/choice.h"
#include "pipeline/holes.h"
#include "pipeline/left_over.h"
#include "pipeline/prepare.h"
#include "pipeline/strategies.h"
#include "plan/layers.h"
#include "plan/walls.h"
#include "read/gcode/gcode.h"
#include "toolpath/kinematics.h"

namespace clearcut {
namespace {

/// Edges of an outline: above the first, strategies whose time grows faster than the edges are not tried; above the second, only the first is.
constexpr std::size_t kMostEdges = 60;
constexpr std::size_t kMostEdgesAtAll = 120;

const Tool& tool_of(const Part& part, const Workingstep& step) {
  return part.tools.at(static_cast<std::size_t>(step.operation.tool));
}

const Feature& feature_of(const Part& part, const Workingstep& step) {
  return part.features.at(static_cast<std::size_t>(step.feature));
}

/// Where nobody says how to go down: a helix under limited engagement and for cutters that cannot plunge.
EntryKind default_entry(const Tool& tool, const Attempt& attempt) {
  return tool.center_cutting && attempt.strategy != "adaptive" ? EntryKind::kPlunge : EntryKind::kHelix;
}

bool has_open_side(const Feature& feature) {
  return feature.kind != FeatureKind::kClosedPocket && feature.kind != FeatureKind::kRoundHole;
}

/// mm. What coarse digits of a controller may move a pass into a wall or floor beyond half of the smallest
/// gouge that counts. The coarser of millimetres and inches decides, so that both are the same path.
double printing_reserve(const PlanOptions& options) {
  PostOptions metric = options.post, inch = options.post;
  metric.inch = false;
  inch.inch = true;
  return std::max(
      {0.0, rounding_of(metric) - options.tol.gouge / 2, rounding_of(inch) - options.tol.gouge / 2});
}

/// Whether rapids may come down through the feature after it is cut: to another one under it, or between leaning
/// walls to layers that begin elsewhere.
bool is_bare(const Part& part, const Feature& feature) {
  if (feature.wall_slope.radians() != 0) return true;
  const Box here = box(feature.target);
  return std::any_of(part.features.begin(), part.features.end(), [&](const Feature& other) {
    return other.floor_z < feature.floor_z && box(other.target).overlaps(here);
  });
}

/// The layers of one workingstep over which something still stands. Open features cut only that; in closed
/// ones the walls bound every pass, so the whole layer is cut.
std::vector<Layer> standing_layers(const Part& part, const Workingstep& step, const PlanOptions& options) {
  const auto& feature = feature_of(part, step);
  Operation operation = step.operation;
  const double reserve = printing_reserve(options);
  operation.allowance_side += reserve;
  operation.allowance_floor += reserve;
  const Tool& tool = tool_of(part, step);
  auto layers = layers_of(feature, operation, tool.radius(), options.tol, tool.corner_radius);
  for (auto& layer : layers) {
    layer.reserve = reserve;
    Regions standing = standing_target(part, step.feature, layer.z, options.tol);
    // It stands in the outline at the top: between leaning walls there is less.
    if (feature.wall_slope.radians() != 0) standing = intersect(standing, layer.allowed, options.tol);
    if (standing.empty() || has_open_side(feature)) layer.target = standing;
    layer.bare = is_bare(part, feature);
  }
  std::erase_if(layers, [](const Layer& layer) { return layer.target.empty(); });
  return layers;
}

/// A layer as it is to be planned.
struct LayerLeft {
  Layer layer;
  bool walls_only = false;
  bool rest = false;  ///< cleared by others around its target
};

/// mm. What others cleared may hold films up to this thick: no place for rapids.
constexpr double kFilmOfOthers = 0.01;

bool finishes(const Operation& operation) {
  return operation.kind == OperationKind::kFinishing || operation.kind == OperationKind::kSideFinishing ||
         operation.kind == OperationKind::kBottomFinishing;
}

/// mm. Most stock that one pass along the walls finishes, of the cutter's diameter.
constexpr double kThinStock = 0.5;

/// What one pass along its walls finishes: thin stock in a pocket closed all round, above the floor or at a floor that is
/// finished otherwise.
bool is_wall_finishing(const Workingstep& step, const Feature& feature, const Regions& left, bool last,
                       const Layer& layer, const PlanOptions& options) {
  if (has_open_side(feature) || !finishes(step.operation)) return false;
  if (step.operation.kind == OperationKind::kFinishing && last) return false;
  return !is_thicker_than(left, 2 * kThinStock * layer.tool_radius, options.tol);
}

/// The layers with what earlier steps of the feature or an earlier program have left of them, where the step is to cut
/// that alone: rest machining and finishing.
std::vector<LayerLeft> layers_left(const std::vector<Layer>& layers, int index, const Part& part,
                                   const PlanOptions& options) {
  const auto& step = part.workplan[static_cast<std::size_t>(index)];
  const bool finishing = finishes(step.operation) && follows_milling(part, index);
  std::vector<LayerLeft> out;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const bool last = i + 1 == layers.size();
    if (finishing && step.operation.kind == OperationKind::kBottomFinishing && !last) continue;
    LayerLeft one{layers[i]};
    const bool whole_floor = finishing && last && step.operation.kind != OperationKind::kSideFinishing;
    if (!whole_floor && (finishing || step.operation.rest || options.earlier)) {
      const Regions left = left_over(part, index, one.layer, options);
      one.walls_only =
          finishing && is_wall_finishing(step, feature_of(part, step), left, last, one.layer, options);
      if (!one.walls_only) one.layer.target = left;
      one.rest = true;
    }
    if (!one.layer.target.empty()) out.push_back(std::move(one));
  }
  return out;
}

void add_size(StepPlan& plan, const Layer& layer, const LayerPasses& passes) {
  plan.legal_mm2 += area(passes.legal);
  std::size_t edges = 0;
  for (const auto& region : passes.legal) {
    for (const auto& edge : region.edges()) plan.legal_rim_mm += edge.length();
    edges += region.edges().size();
  }
  const double whole = area(layer.allowed);
  plan.pocket = plan.pocket && edges <= kMostEdges && whole - area(layer.target) <= 1e-9 * whole;
}

/// What a strategy makes of one workingstep.
StepPlan plan_step(int index, const Part& part, const Attempt& attempt, const PlanOptions& options) {
  const auto& step = part.workplan[static_cast<std::size_t>(index)];
  const auto strategy = strategy_for(attempt, step.operation, options);
  const auto layers = standing_layers(part, step, options);
  StepPlan plan;
  if (auto hole = hole_step(layers, index, part, options)) {
    plan.section = *std::move(hole);
    plan.hole = true;
  } else {
    std::vector<LayerPasses> passes;
    for (const auto& layer : layers_left(layers, index, part, options)) {
      passes.push_back(layer.walls_only ? plan_walls(layer.layer, options.tol) : strategy(layer.layer));
      if (layer.rest) passes.back().film = std::max(passes.back().film, kFilmOfOthers);
      add_size(plan, layer.layer, passes.back());
      plan.pocket = plan.pocket && !layer.rest;
    }
    plan.section = link_step(passes, index, default_entry(tool_of(part, step), attempt), part, options);
  }
  plan.time_s = kinematic_time(plan.section.moves, options.machine).seconds();
  return plan;
}

std::vector<ChoiceStep> choice_steps(const Part& part) {
  std::vector<ChoiceStep> steps;
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    const auto& step = part.workplan[i];
    const auto& feature = feature_of(part, step);
    std::size_t edges = 0;
    for (const auto& region : feature.allowed) edges += region.edges().size();
    steps.push_back({feature.name, static_cast<int>(i), tool_of(part, step).radius(),
                     *step.operation.cutting.feed, edges <= kMostEdgesAtAll});
  }
  return steps;
}

std::string does_not_fit(const Part& part, const Workingstep& step, const PlanOptions& options) {
  if (only_plunges(tool_of(part, step)) && !round_hole_of(feature_of(part, step), options.tol)) {
    return fmt::format("tool T{} ({} {} mm) only makes round holes; {} needs a mill",
                       tool_of(part, step).number, name_of(tool_of(part, step).kind),
                       trimmed(tool_of(part, step).diameter, 4), feature_of(part, step).name);
  }
  return fmt::format("tool T{} ({} mm) does not fit {}; the largest that does has {} mm",
                     tool_of(part, step).number, trimmed(tool_of(part, step).diameter, 4),
                     feature_of(part, step).name,
                     trimmed(largest_fitting_diameter(feature_of(part, step), options.tol), 3));
}

/// Edges of an outline beyond which rivals are not tried: their time would be felt.
constexpr std::size_t kMostEdgesForRivals = 400;

std::size_t edges_of(const Feature& feature) {
  std::size_t count = 0;
  for (const auto& region : feature.allowed) count += region.edges().size();
  return count;
}

/// The plan of an attempt, or of a rival that is faster.
StepPlan fastest_plan(int index, const Part& part, const Attempt& attempt, const PlanOptions& options) {
  StepPlan best = plan_step(index, part, attempt, options);
  const auto& feature = feature_of(part, part.workplan[static_cast<std::size_t>(index)]);
  const bool alone = !attempt.beside_rivals || best.hole || edges_of(feature) > kMostEdgesForRivals;
  if (alone || best.section.moves.empty()) return best;
  for (const auto& rival : rival_attempts()) {
    StepPlan plan = plan_step(index, part, rival, options);
    if (plan.section.moves.empty() || plan.time_s >= best.time_s) continue;
    best.section = std::move(plan.section);
    best.time_s = plan.time_s;
  }
  return best;
}

/// Degrees. Above this the cutter is taken to be in a slot.
constexpr double kSlotAngle = 150;

/// Slows down wherever a step with a slot feed is in the material all round, given all that runs before.
void slow_down_slots(Toolpath& toolpath, const Part& part, const PlanOptions& options) {
  const auto slot_feed_of = [&](const Section& section) {
    return part.workplan[static_cast<std::size_t>(section.workingstep)].operation.cutting.slot_feed;
  };
  const bool wanted = std::any_of(toolpath.sections.begin(), toolpath.sections.end(),
                                  [&](const Section& section) { return slot_feed_of(section).has_value(); });
  if (!wanted) return;
  std::vector<double> radii;
  for (const auto& tool : part.tools) radii.push_back(tool.radius());
  Material material(part.stock ? std::optional(part.stock->plan) : std::nullopt, part.top_z(), radii);
  const Radians limit = Radians::of_degrees(options.shop.slot_angle_deg.value_or(kSlotAngle));
  for (auto& section : toolpath.sections) {
    const auto& step = part.workplan[static_cast<std::size_t>(section.workingstep)];
    slow_down_slots(section, tool_of(part, step).radius(), limit,
                    slot_feed_of(section).value_or(*step.operation.cutting.feed), material);
  }
}

Toolpath toolpath_of(const Choice& choice, const Part& part, const PlanOptions& options) {
  Toolpath toolpath;
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    if (!choice.section(i).moves.empty()) toolpath.sections.push_back(choice.section(i));
  }
  slow_down_slots(toolpath, part, options);
  return toolpath;
}

void report_notes(const Choice& choice, Part& part) {
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    const Section& section = choice.section(i);
    for (const auto& text : section.notes) part.diagnostics.note(section.label, text);
  }
}

void report_what_does_not_fit(Part& part, const Choice& choice, const PlanOptions& options) {
  bool nothing = true;
  for (std::size_t i = 0; i < part.workplan.size(); ++i) nothing = nothing && choice.section(i).moves.empty();
  if (nothing) {
    throw InputError(part.source_file,
                     "nothing can be cut: " + does_not_fit(part, part.workplan.front(), options));
  }
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    const auto& step = part.workplan[i];
    if (!choice.section(i).moves.empty()) continue;
    const bool fits =
        tool_of(part, step).diameter <= largest_fitting_diameter(feature_of(part, step), options.tol);
    const auto layers = standing_layers(part, step, options);
    if (fits && layers_left(layers, static_cast<int>(i), part, options).empty()) continue;
    part.diagnostics.skip(feature_of(part, step).name, does_not_fit(part, step, options));
  }
}

/// Takes the next best plan of every workingstep that was not certified clean. False when there was nothing to do.
bool retry_unclean(Choice& choice, PlanResult& result) {
  bool retried = false;
  for (const auto& feature : result.findings.features) {
    if (feature.figures.clean || feature.workingstep < 0) continue;
    const auto i = static_cast<std::size_t>(feature.workingstep);
    if (!choice.next(i)) continue;
    const Attempt& next = choice.attempt(i);
    result.part.diagnostics.note(feature.name,
                                 "was not certified clean at first and is planned again: " + next.strategy +
                                     (next.stepover ? ", stepover " + *next.stepover : ""));
    retried = true;
  }
  return retried;
}

/// One unnumbered tool given for a program that uses one tool: they are the same, whatever its number there.
PlanOptions numbered_by(const Toolpath& toolpath, PlanOptions options) {
  if (options.tools.size() != 1 || options.tools.front().number != 0 || toolpath.sections.empty())
    return options;
  const int number = toolpath.sections.front().tool_number;
  const bool one = std::all_of(toolpath.sections.begin(), toolpath.sections.end(),
                               [&](const Section& section) { return section.tool_number == number; });
  if (one && number > 0) options.tools.front().number = number;
  return options;
}

/// A program without a T word runs with the one tool there is.
void number_sections(Toolpath& toolpath, const Part& part) {
  if (part.tools.size() != 1) return;
  for (auto& section : toolpath.sections) {
    if (section.tool_number == 0) section.tool_number = part.tools.front().number;
  }
}

/// A program of another CAM is held to the stepdown that somebody stated, not to our default.
void keep_stated_stepdowns(Part& prepared, const Part& part, const PlanOptions& options) {
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    const bool mills = !only_plunges(tool_of(prepared, prepared.workplan[i]));
    prepared.workplan[i].operation.stepdown =
        options.stepdown && mills ? options.stepdown : part.workplan[i].operation.stepdown;
  }
}

}  // namespace

PlanResult plan(const Part& part, const PlanOptions& options) {
  PlanResult result;
  result.part = prepare(part, options);
  const auto planner = [&](int step, const Attempt& attempt) {
    return fastest_plan(step, result.part, attempt, options);
  };
  Choice choice(choice_steps(result.part), attempts_for(options), planner, options);
  report_what_does_not_fit(result.part, choice, options);
  const auto toolpath = [&] { return toolpath_of(choice, result.part, options); };
  certify(result, toolpath(), options);
  while (retry_unclean(choice, result)) certify(result, toolpath(), options);
  sign(result, toolpath(), options);
  report_notes(choice, result.part);
  result.contests = choice.contests();
  return result;
}

JudgeResult judge(const Part& part, const std::string& program, const std::string& program_name,
                  const PlanOptions& options) {
  auto read = read_gcode(program, program_name);
  JudgeResult result;
  result.part = prepare(part, numbered_by(read.toolpath, options));
  keep_stated_stepdowns(result.part, part, options);
  result.part.diagnostics.append(read.diagnostics);
  result.toolpath = std::move(read.toolpath);
  number_sections(result.toolpath, result.part);
  result.findings = verify(result.part, result.toolpath, verify_options(options));
  return result;
}

}  // namespace clearcut
