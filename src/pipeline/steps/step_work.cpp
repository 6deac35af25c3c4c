#include "pipeline/steps/step_work.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "base/progress.h"
#include "features/derived_outlines.h"
#include "features/round_hole.h"
#include "features/standing.h"
#include "geometry/contours/boolean.h"
#include "geometry/spatial/apart.h"
#include "geometry/voronoi/clearance.h"
#include "model/cutter_profile.h"
#include "pipeline/steps/other_features.h"
#include "pipeline/steps/steps_without_layers.h"
#include "plan/common/clearing_area.h"
#include "plan/common/layers.h"
#include "post/post.h"
#include "resolve/left_over.h"
#include "resolve/unreached.h"

namespace clearcut::pipeline {
namespace {

/// mm. Displacement of a pass by the digits of a controller in excess of half of the smallest gouge.
double printing_reserve(double rounding, const ResolvedPlan& plan) {
  return std::max(0.0, rounding - plan.tol.gouge / 2);
}

/// Whether rapids may descend through the finished feature: to another one below, or between drafted
/// walls to layers beginning elsewhere.
bool is_bare(const Part& part, const Feature& feature) {
  if (feature.wall_slope.radians() != 0) return true;
  const Box here = box(feature.target);
  return std::any_of(part.features.begin(), part.features.end(), [&](const Feature& other) {
    return other.floor_z < feature.floor_z && box(other.target).overlaps(here);
  });
}

/// The area cut for an open feature: with the requested overrun beyond its edges, except at walls.
Regions overrun(const Regions& target, const Regions& allowed, const ResolvedPlan& plan) {
  const double beyond = plan.overrun;
  if (beyond <= 0 || target.empty()) return target;
  return intersect(dilate(target, beyond, plan.tol), allowed, plan.tol);
}

/// Reduces a layer that is clear by design to the material missed by other features, with the room left by them for
/// reaching it.
void keep_what_others_missed(Layer& layer, int index, MeetingPockets& met, const ResolvedPlan& plan) {
  Layer wide = layer;
  if (!met.empty()) met.widen(wide);
  wide.target = layer.target;
  layer.target = missed_by_others(index, wide, plan);
  if (!layer.target.empty()) layer.allowed = wide.allowed;
}

/// Whether layers that keep off leaning walls as a flat end has to leave more on them than may stand, however thin they are. Those that
/// touch the walls leave more beside the steeper walls of others.
bool has_to_touch(const plan::RoundOnWall& touch, const Operation& operation) {
  return operation.scallop && touch.draft > 0 && touch.round > 0 &&
         !touch.height_kept_off(*operation.scallop);
}

/// Whether the cutter that touches the leaning walls of `feature` keeps off what stands above it: the upright walls of pockets that it lies
/// under are as far beside its outline as the rounded end is wider there.
bool is_free_above(const Part& part, const Feature& feature, const plan::RoundOnWall& touch,
                   const Tolerances& tol) {
  if (feature.top_z >= part.top_z()) return true;
  Regions stands = dilate(feature.allowed, touch.round - touch.beside(), tol);
  for (const Feature& other : part.features) {
    if (&other == &feature || other.floor_z > feature.top_z || other.profile || other.chamfer) continue;
    const double deep = std::max(0.0, other.top_z - feature.top_z);
    stands = subtract(stands, features::at_depth(other.allowed, other.wall_slope, deep, tol), tol);
  }
  return stands.empty();
}

/// Whether a rounded end comes as near to the leaning walls of the step's feature as it may. Upright walls of what stands above it has to
/// keep off by its whole radius. Beside the layers of another step it keeps the distance of a flat end, unless that leaves too much.
bool touches_walls(const Part& part, const Workingstep& step, const plan::RoundOnWall& touch, bool meets_none,
                   const Tolerances& tol) {
  const auto steps = std::count_if(part.workplan.begin(), part.workplan.end(),
                                   [&](const Workingstep& other) { return other.feature == step.feature; });
  const bool begins_at_top = feature_of(part, step).top_z >= part.top_z();
  if (steps == 1 && begins_at_top && meets_none) return true;
  return has_to_touch(touch, step.operation) && is_free_above(part, feature_of(part, step), touch, tol);
}

/// mm by which the cutter of a step may be off its path or its size: by the machine's error that the plan has to hold for, or by the
/// wear that the control is told for passes along the walls alone, while the cutter of all other passes of the feature is as worn.
double off_path(int index, const ResolvedPlan& plan) {
  const double error = plan.margin ? plan.margin->at_least : 0;
  const auto& wear = plan.post.wear;
  if (!wear || wear->shifts(index)) return error;
  const auto& step = plan.part.workplan[static_cast<std::size_t>(index)];
  const bool wears = std::any_of(wear->workingsteps.begin(), wear->workingsteps.end(), [&](int other) {
    return plan.part.workplan[static_cast<std::size_t>(other)].feature == step.feature;
  });
  return wears ? std::max(error, wear->range) : error;
}

/// Keeps a corner sharper than the fillet between the feature's floor and walls off the fillet, at the height of the layer. Where another
/// tool makes the fillet, or none does, the rest is left. Layers that do not touch leaning walls keep off them by some of it already.
void keep_off_fillet(Layer& layer, const Feature& feature, const plan::RoundedEnd& end,
                     const Tolerances& tol) {
  const plan::RoundOnWall touch{end.round, feature.wall_slope.radians()};
  const double kept = end.touches_walls ? 0 : end.round - touch.beside();
  const double off = touch.clear_of_fillet(feature.floor_fillet, layer.z - feature.floor_z) - kept;
  if (off <= 0) return;
  layer.allowed = inset(layer.allowed, off, tol);
  layer.target = intersect(layer.target, layer.allowed, tol);
}

/// The end of the cutter of a step, as it comes to the walls of the step's feature.
plan::RoundedEnd end_of(const Workingstep& step, const ResolvedPlan& plan, bool meets_none) {
  const plan::RoundOnWall touch{outer_profile(tool_of(plan.part, step)).round,
                                feature_of(plan.part, step).wall_slope.radians()};
  return {touch.round, touches_walls(plan.part, step, touch, meets_none, plan.tol)};
}

/// Whether a step cuts layers of the same feature as a later one, and comes no nearer to its walls.
bool cuts_layers_before(const Workingstep& earlier, const Workingstep& step, const Part& part) {
  return earlier.feature == step.feature && earlier.operation.kind != OperationKind::kBottomFinishing &&
         clears_floors(tool_of(part, earlier)) &&
         earlier.operation.allowance_side >= step.operation.allowance_side - kSamePlaceMm;
}

/// The heights that all earlier steps share on a feature with leaning walls; the topmost layer begins at `top`.
std::vector<double> heights_of_earlier(int index, const ResolvedPlan& plan, double top, bool meets_none) {
  const Part& part = plan.part;
  const Workingstep& step = part.workplan[static_cast<std::size_t>(index)];
  const Feature& feature = feature_of(part, step);
  std::vector<double> shared;
  if (feature.wall_slope.radians() <= 0) return shared;
  for (int i = 0; i < index; ++i) {
    const Workingstep& earlier = part.workplan[static_cast<std::size_t>(i)];
    if (!cuts_layers_before(earlier, step, part)) continue;
    const std::vector<double> heights =
        plan::heights_of(feature, earlier.operation, tool_of(part, earlier).radius(),
                         end_of(earlier, plan, meets_none), top, shared);
    if (shared.empty()) {
      shared = heights;
      continue;
    }
    std::erase_if(shared, [&](double z) {
      return std::none_of(heights.begin(), heights.end(),
                          [&](double other) { return std::abs(z - other) <= kSamePlaceMm; });
    });
  }
  return shared;
}

/// The layers of one workingstep over which something still stands. Open features cut only that, and pockets of which
/// nothing but stock of earlier work is left; in others the walls bound every pass, so the whole layer is cut.
std::vector<Layer> standing_layers(int index, const ResolvedPlan& plan, double reserve_share) {
  const Part& part = plan.part;
  const auto& step = part.workplan[static_cast<std::size_t>(index)];
  const auto& feature = feature_of(part, step);
  Operation operation = step.operation;
  const double reserve = reserve_share * reserve_for_digits(plan);
  // A cutter that may be off its path certainly clears the area of a narrower one, with a correspondingly greater
  // distance from the walls.
  const double spared = plan.margin ? plan.margin->stock() : 0;
  const double narrower = std::min(off_path(index, plan), tool_of(part, step).radius() / 4);
  operation.allowance_side += std::max(reserve, spared) + narrower;
  operation.allowance_floor += std::max(printing_reserve(post::rounding_of_heights(plan.post), plan), spared);
  const Tool& tool = tool_of(part, step);
  MeetingPockets met(part, index, plan.tol);
  // If layers are widened by pockets of other depths, the passes of a layer begin at other places than those of the
  // layer above.
  const bool bare = is_bare(part, feature) || !met.empty();
  const auto holes = features::holes_before(part, index, plan.tol);
  const features::Standing standing(part, index, plan.tol, [&plan](int earlier) {
    return !plan.steps[static_cast<std::size_t>(earlier)].published_grid;
  });
  const plan::RoundedEnd end = end_of(step, plan, met.empty());
  const double top = standing.top();
  const std::vector<double> others = heights_of_earlier(index, plan, top, met.empty());
  if (end.touches_walls) met.touch_walls({end.round, feature.wall_slope.radians()});
  auto layers = plan::layers_of(feature, operation, tool.radius() - narrower, plan.tol, end,
                                top - feature.top_z, others);
  MeetingPockets missed = met;  // layers that nothing stands over widen no others
  for (auto at = layers.rbegin(); at != layers.rend(); ++at) {
    Layer& layer = *at;
    layer.reserve = std::max(reserve, spared);
    layer.holes = holes;
    if (part.stock) layer.stock = part.stock->plan;
    Regions stands = standing.above(layer.z);
    // The material is bounded by the outline at the top: between drafted walls there is less.
    if (feature.wall_slope.radians() != 0) stands = intersect(stands, layer.allowed, plan.tol);
    if (stands.empty() && closed_all_round(feature)) {
      keep_what_others_missed(layer, index, missed, plan);
    } else if (!closed_all_round(feature) || layer.z >= feature.top_z) {
      layer.target = overrun(stands, layer.allowed, plan);
      if (!layer.target.empty() && !closed_all_round(feature)) met.widen(layer);
    } else if (!met.empty()) {
      met.widen(layer);
    }
    layer.bare = bare;
    keep_off_fillet(layer, feature, end, plan.tol);
  }
  std::erase_if(layers, [](const Layer& layer) { return layer.target.empty(); });
  const double across = plan.steps[static_cast<std::size_t>(index)].cross_z;
  for (auto& layer : layers) layer.lift = across - (layers.front().z + layers.back().z) / 2;
  return layers;
}

bool finishes(const Operation& operation) {
  return operation.kind == OperationKind::kFinishing || operation.kind == OperationKind::kSideFinishing ||
         operation.kind == OperationKind::kBottomFinishing;
}

/// mm. Greatest stock finished by one pass along the walls, as a share of the cutter's diameter.
constexpr double kThinStock = 0.5;

/// Calls f with the earlier milling steps of the step's feature, in their order.
template <typename F>
void for_earlier_steps(const Workingstep& step, const Part& part, F&& f) {
  for (const Workingstep& other : part.workplan) {
    if (&other == &step) break;
    if (other.feature == step.feature && clears_floors(tool_of(part, other))) f(other);
  }
}

/// mm, more than a step leaves on walls, that an earlier one has left there.
double stock_between(const Workingstep& earlier, const Workingstep& step) {
  return earlier.operation.allowance_side - step.operation.allowance_side;
}

/// What earlier steps with a cutter that reaches no less have cleared beside the walls that the step finishes.
void add_room_of_earlier_steps(Layer& layer, const Workingstep& step, const Part& part) {
  for_earlier_steps(step, part, [&](const Workingstep& earlier) {
    const bool reaches_less = tool_of(part, earlier).radius() > tool_of(part, step).radius() + kSamePlaceMm;
    const double lowest = feature_of(part, earlier).floor_z + earlier.operation.allowance_floor;
    if (reaches_less || lowest > layer.z + kRoundingMm) return;
    const double stock = std::max(0.0, stock_between(earlier, step));
    layer.cleared_beyond = std::min(layer.cleared_beyond.value_or(stock), stock);
    layer.room_beside = std::max(layer.room_beside, stock);
    if (feature_of(part, earlier).profile)
      layer.cleared_to = std::max(layer.cleared_to.value_or(stock), stock);
  });
}

/// Whether a pass along the walls would exceed the limit of engagement in their corners. Between passes of the same width nothing is
/// left.
bool is_over_limit_along_walls(const Workingstep& step, const Regions& left, const Layer& layer,
                               const ResolvedPlan& plan) {
  if (!plan.engagement_deg || left.empty()) return false;
  double stock = 0;  // mm that the last earlier step leaves
  for_earlier_steps(step, plan.part,
                    [&](const Workingstep& earlier) { stock = stock_between(earlier, step); });
  return stock > plan.tol.uncut && plan::engagement_along_walls(layer.allowed, layer.tool_radius, stock) >
                                       Radians::of_degrees(*plan.engagement_deg).radians();
}

/// Whether one pass along the walls finishes the step: thin stock in a pocket closed all round, above the floor or
/// with a floor finished by another step.
bool is_wall_finishing(const Workingstep& step, const Feature& feature, const Regions& left, bool last,
                       const Layer& layer, const ResolvedPlan& plan) {
  if (!closed_all_round(feature) || !finishes(step.operation)) return false;
  if (is_over_limit_along_walls(step, left, layer, plan)) return false;
  if (step.operation.kind == OperationKind::kFinishing && last) return false;
  return !resolve::is_thicker_than(left, 2 * kThinStock * layer.tool_radius, plan.tol);
}

/// Boundaries of earlier steps of a feature that overlaps other pockets: those are open down to their floors, and the
/// layers of a step with a wider cutter may all be below.
class RoomOfEarlierSteps {
 public:
  RoomOfEarlierSteps(const ResolvedPlan& plan, const std::vector<double>& reserve_shares)
      : plan_(plan), reserve_shares_(reserve_shares) {}

  /// The boundary of the highest layer of `step` at z or below.
  std::optional<Regions> operator()(int step, double z) {
    const auto [known, added] = layers_.try_emplace(step);
    if (added) known->second = standing_layers(step, plan_, reserve_shares_[static_cast<std::size_t>(step)]);
    for (const Layer& layer : known->second)
      if (layer.z <= z + plan_.tol.coincident) return layer.allowed;
    return std::nullopt;
  }

 private:
  const ResolvedPlan& plan_;
  const std::vector<double>& reserve_shares_;
  std::map<int, std::vector<Layer>> layers_;  ///< from the top down
};

/// The layers with the material left by earlier steps of the feature or an earlier program, if the step cuts only
/// this: rest machining and finishing.
std::vector<LayerLeft> layers_left(const std::vector<Layer>& layers, int index, const ResolvedPlan& plan,
                                   const std::vector<double>& reserve_shares) {
  const Part& part = plan.part;
  const auto& step = part.workplan[static_cast<std::size_t>(index)];
  const bool finishing = finishes(step.operation) && resolve::follows_milling(part, index);
  const bool met = resolve::meets_earlier(part, index, plan.earlier);
  const std::optional<Toolpath> earlier = met ? plan.earlier : std::nullopt;
  std::vector<LayerLeft> out;
  RoomOfEarlierSteps rooms(plan, reserve_shares);
  // Earlier steps had less room than this one where others have opened its walls, or where they kept off a fillet.
  const bool had_less_room =
      !MeetingPockets(part, index, plan.tol).empty() || feature_of(part, step).floor_fillet > 0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const bool last = i + 1 == layers.size();
    if (finishing && step.operation.kind == OperationKind::kBottomFinishing && !last) continue;
    LayerLeft one{layers[i]};
    const bool whole_floor =
        finishing && last && !step.operation.rest && step.operation.kind != OperationKind::kSideFinishing;
    if (!whole_floor && (finishing || step.operation.rest || met)) {
      resolve::RoomBefore room;
      if (had_less_room) room = [&](int earlier_step) { return rooms(earlier_step, one.layer.z); };
      const Regions left = resolve::left_over(part, index, one.layer, earlier, plan.tol, room);
      one.walls_only =
          finishing && is_wall_finishing(step, feature_of(part, step), left, last, one.layer, plan);
      if (!one.walls_only) one.layer.target = left, one.layer.rest = true;
      if (step.operation.kind == OperationKind::kSideFinishing)
        add_room_of_earlier_steps(one.layer, step, part);
      one.rest = true;
    }
    if (!one.layer.target.empty()) out.push_back(std::move(one));
  }
  return out;
}

/// mm. Walls of features above no farther than this from the feature's own walls may block a rapid only because of
/// rounding.
constexpr double kFlush = 0.03;

/// Top of the features above that do not extend beyond this one's walls all round.
std::optional<double> top_of_flush_walls(const Part& part, const Feature& feature, const Tolerances& tol) {
  std::optional<double> top;
  std::optional<Regions> around;  // made at the first use: few features are below others
  for (const Feature& other : part.features) {
    const bool above = &other != &feature && other.floor_z > feature.floor_z && other.top_z > feature.top_z;
    if (!above || are_apart(other.target, feature.target, 2 * tol.chord)) continue;
    if (intersect(other.target, feature.target, tol).empty()) continue;
    if (!around) around = dilate(feature.target, kFlush, tol);
    if (!subtract(*around, other.allowed, tol).empty())
      top = std::max(top.value_or(other.top_z), other.top_z);
  }
  return top;
}

/// Whether any other feature may share area with this one.
bool meets_others(const Part& part, const Feature& feature) {
  const Box here = box(feature.target);
  return std::any_of(part.features.begin(), part.features.end(), [&](const Feature& other) {
    return &other != &feature && box(other.target).overlaps(here);
  });
}

/// mm2. Less area of stock beside a target is rounding.
constexpr double kNoStock = 1e-3;

/// Whether nothing rests on what passes clear beyond the targets of the layers: no other feature is so near that a cutter may touch
/// both, no other step cuts the feature, and where the cutter may be there is no stock beside the targets.
bool stands_alone(const StepWork& work, const ResolvedPlan& plan) {
  const Part& part = plan.part;
  const auto& step = part.workplan[static_cast<std::size_t>(work.workingstep)];
  const Feature& feature = feature_of(part, step);
  if (plan.earlier || !part.stock || feature.profile || feature.wall_slope.radians() != 0 ||
      feature.floor_fillet > 0)
    return false;
  if (!outer_profile(tool_of(part, step)).is_cylinder()) return false;
  double widest = 0;
  for (const Tool& tool : part.tools) widest = std::max(widest, tool.diameter);
  for (const Workingstep& other : part.workplan) {
    if (&other == &step) continue;
    if (other.feature == step.feature ||
        !are_apart(feature_of(part, other).target, feature.target, 2 * widest))
      return false;
  }
  return std::all_of(work.layers.begin(), work.layers.end(), [&](const LayerLeft& left) {
    const Layer& layer = left.layer;
    if (left.walls_only || left.rest) return false;
    const Regions stock{rectangular_region(part.stock->plan)};
    return area(subtract(intersect(stock, layer.allowed, plan.tol), layer.target, plan.tol)) < kNoStock;
  });
}

/// Whether all earlier cuts were made in earlier set-ups.
bool is_carried_alone(const Toolpath& earlier) {
  return std::all_of(earlier.sections.begin(), earlier.sections.end(),
                     [](const Section& section) { return section.carried_below.has_value(); });
}

StepWork step_work(int index, const ResolvedPlan& plan, const std::vector<double>& reserve_shares) {
  const Part& part = plan.part;
  const double reserve_share = reserve_shares[static_cast<std::size_t>(index)];
  StepWork work;
  work.workingstep = index;
  const Feature& feature = feature_of(part, part.workplan[static_cast<std::size_t>(index)]);
  work.meets_others = meets_others(part, feature);
  work.wall_top = top_of_flush_walls(part, feature, plan.tol);
  work.hole = stated_step(index, plan);
  if (!work.hole) work.hole = carve_step(index, reserve_share, plan);
  if (!work.hole) work.hole = formed_hole_step(index, plan);
  if (!work.hole) work.hole = t_slot_step(index, plan);
  if (work.hole) return work;
  const auto standing = standing_layers(index, plan, reserve_share);
  work.hole = hole_step(standing, index, plan);
  work.layers = layers_left(standing, index, plan, reserve_shares);
  work.done_before = plan.earlier && !standing.empty() && work.layers.empty();
  work.stands_alone = !closed_all_round(feature) && stands_alone(work, plan);
  // A hole drilled in an earlier set-up is not drilled again.
  if (work.done_before && is_carried_alone(*plan.earlier)) work.hole.reset();
  return work;
}

}  // namespace

double reserve_for_digits(const ResolvedPlan& plan) {
  return printing_reserve(post::rounding_of(plan.post), plan);
}

std::vector<StepWork> step_works(const ResolvedPlan& plan, const std::vector<double>& reserve_shares) {
  std::vector<StepWork> works(plan.part.workplan.size());
  const std::vector<std::string> unreached = resolve::unreached_steps(plan.part, plan.tol);
  on_threads(plan.threads, [&] {
    parallel_in_order(works.size(), [&](std::size_t i) {
      throw_if_cancelled(plan.cancel);
      works[i].workingstep = static_cast<int>(i);
      if (unreached[i].empty()) works[i] = step_work(static_cast<int>(i), plan, reserve_shares);
    });
  });
  return works;
}

std::vector<StepWork> step_works(const ResolvedPlan& plan) {
  return step_works(plan, std::vector<double>(plan.part.workplan.size(), 1));
}

namespace {

/// mm2; area to be cleared by the layers of a step.
double area_of(const StepWork& work) {
  double all = 0;
  for (const auto& layer : work.layers) all += area(layer.layer.target);
  return all;
}

}  // namespace

std::vector<std::uint64_t> work_shares(const std::vector<StepWork>& works, const ResolvedPlan& plan) {
  double all = 0;
  for (const StepWork& work : works) all += area_of(work);
  std::vector<std::uint64_t> shares;
  for (std::size_t i = 0; i < works.size(); ++i) {
    const double share = all > 0 ? area_of(works[i]) / all : 1;
    const auto own = static_cast<std::uint64_t>(share * static_cast<double>(kMostWork));
    shares.push_back(plan.steps[i].strategy ? kMostWorkAlone : std::max(own, kLeastWork));
  }
  return shares;
}

}  // namespace clearcut::pipeline
