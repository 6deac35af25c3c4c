#include "pipeline/steps/other_features.h"

#include <algorithm>
#include <iterator>

#include "features/derived_outlines.h"
#include "features/round_hole.h"
#include "geometry/contours/boolean.h"
#include "geometry/gaps/unite_over_gaps.h"
#include "geometry/spatial/apart.h"
#include "geometry/voronoi/clearance.h"
#include "model/cutter_profile.h"
#include "plan/common/clearing_area.h"
#include "plan/common/layers.h"
#include "resolve/left_over.h"

namespace clearcut::pipeline {
namespace {

/// mm. Outlines no farther apart touch; areas extending no farther beyond an outline do not count.
constexpr double kTouching = 0.005;

/// mm. Material between two outlines no thicker than the permitted depth of a gouge is no wall: one line, drawn
/// twice. The verifier treats it the same way.
constexpr double kGap = 0.001;
/// mm. Shorter edges are remnants of unions of nearly coincident outlines.
constexpr double kShortEdge = 0.0004;

/// Whether no other cutter may enter the feature: undercuts, and bosses that get a thread.
bool is_for_own_cutter(const Feature& feature) {
  return feature.kind == FeatureKind::kTSlot || feature.kind == FeatureKind::kExternalThread;
}

bool runs_into(const Feature& other, const Regions& around, const Tolerances& tol) {
  return !are_apart(other.allowed, around, 2 * tol.chord) && !intersect(other.allowed, around, tol).empty() &&
         !subtract(other.allowed, around, tol).empty();
}

/// The area around a pocket cleared by the cutters of earlier workingsteps down to the pocket's top or deeper.
Regions cleared_before(const Part& part, int workingstep, const Tolerances& tol) {
  const Feature& pocket = feature_of(part, part.workplan[static_cast<std::size_t>(workingstep)]);
  Regions cleared;
  for (int i = 0; i < workingstep; ++i) {
    const Workingstep& step = part.workplan[static_cast<std::size_t>(i)];
    const Feature& other = feature_of(part, step);
    const bool deep = other.floor_z + step.operation.allowance_floor <= pocket.top_z + tol.coincident;
    if (!deep || &other == &pocket || other.wall_slope.radians() != 0 || other.profile || other.chamfer ||
        makes_holes(tool_of(part, step)))
      continue;
    const Tool& tool = tool_of(part, step);
    const double above = pocket.top_z - other.floor_z - step.operation.allowance_floor;
    const double narrower = std::max(0.0, tool.radius() - radius_cleared(tool, above));
    cleared = unite(
        cleared, resolve::swept(other.allowed, tool.radius(), step.operation.allowance_side, -narrower, tol),
        tol);
  }
  return cleared;
}

}  // namespace

MeetingPockets::MeetingPockets(const Part& part, int workingstep, const Tolerances& tol) : tol_(tol) {
  const Workingstep& step = part.workplan[static_cast<std::size_t>(workingstep)];
  const Feature& pocket = feature_of(part, step);
  const bool is_hole = pocket.kind == FeatureKind::kRoundHole && !is_formed(pocket);
  leans_ = pocket.wall_slope.radians() != 0;
  corner_ = outer_profile(tool_of(part, step)).round;
  if (pocket.profile) return;
  const bool leaves_stock = (is_hole || !closed_all_round(pocket)) && step.operation.allowance_side > 0;
  if (pocket.kind != FeatureKind::kClosedPocket && !leaves_stock) return;
  const Box here = box(pocket.target).grown(kTouching);
  std::optional<Regions> around;  // made at the first use: most pockets do not overlap others
  for (int i = 0; i < static_cast<int>(part.workplan.size()); ++i) {
    const Feature* other = &feature_of(part, part.workplan[static_cast<std::size_t>(i)]);
    if (other == &pocket || is_for_own_cutter(*other) || other->floor_z >= pocket.top_z ||
        !box(other->allowed).overlaps(here))
      continue;
    if (std::find(met_.begin(), met_.end(), other) != met_.end()) continue;
    if (!around) around = dilate(pocket.target, kTouching, tol);
    if (!runs_into(*other, *around, tol)) continue;
    if (i > workingstep && other->top_z > pocket.top_z) {
      if (higher_.empty()) cleared_ = cleared_before(part, workingstep, tol);
      if (cleared_.empty()) continue;
      higher_.push_back(other);
    }
    met_.push_back(other);
  }
}

Regions MeetingPockets::room_of(const Feature& other, double z) const {
  Regions room = features::at_depth(other.allowed, other.wall_slope, other.top_z - z, tol_);
  const plan::RoundOnWall theirs{own_.round, other.wall_slope.radians()};
  const plan::RoundOnWall corner{corner_, theirs.draft};
  const double kept =
      own_.round > 0 ? 0 : corner_ - corner.beside();  // by layers that do not touch leaning walls
  const double off_fillet =
      std::max(0.0, corner.clear_of_fillet(other.floor_fillet, z - other.floor_z) - kept);
  const double farther = theirs.beside() - own_.beside() + off_fillet;
  if (farther > 0) room = inset(room, farther, tol_);
  const bool higher = std::find(higher_.begin(), higher_.end(), &other) != higher_.end();
  return higher ? intersect(room, cleared_, tol_) : room;
}

std::vector<const Feature*> MeetingPockets::open_at(double z) const {
  std::vector<const Feature*> open;
  std::copy_if(met_.begin(), met_.end(), std::back_inserter(open),
               [&](const Feature* other) { return other->floor_z <= z; });
  return open;
}

void MeetingPockets::widen(Layer& layer) {
  const auto open = open_at(layer.z);
  if (open.empty()) return;
  const bool upright = std::all_of(open.begin(), open.end(),
                                   [](const Feature* other) { return other->wall_slope.radians() == 0; });
  const bool alike = upright && std::all_of(open.begin(), open.end(),
                                            [](const Feature* other) { return other->floor_fillet <= 0; });
  if (!alike || open != last_open_ || !plan::same_outline(layer.allowed, last_allowed_)) {
    last_added_ = added_to(layer, open);
    last_allowed_ = layer.allowed;
    last_open_ = open;
    if ((leans_ || !upright) && last_added_)
      below_ = below_.empty() ? *last_added_ : unite(below_, *last_added_, tol_);
  }
  if (!last_added_) return;
  const Regions wide = without_short_edges(unite(layer.allowed, *last_added_, tol_), kShortEdge);
  layer.target = plan::closed_all_round(layer)
                     ? wide
                     : unite(layer.target, subtract(*last_added_, layer.allowed, tol_), tol_);
  layer.allowed = wide;
}

std::optional<Regions> MeetingPockets::added_to(const Layer& layer,
                                                const std::vector<const Feature*>& open) const {
  Regions wide = layer.allowed;
  for (const Feature* other : open) wide = unite_over_gaps(wide, room_of(*other, layer.z), kGap, tol_);
  const double around = 2 * (layer.tool_radius + layer.wall_stock);
  const Regions near = dilate(layer.allowed, around, tol_);
  const auto reached = [&](const Regions& allowed, double more) {
    return resolve::swept(allowed, layer.tool_radius, layer.wall_stock, more, tol_);
  };
  const Regions with_others = intersect(layer.target, reached(intersect(wide, near, tol_), 0), tol_);
  // Slightly enlarged, since otherwise slivers remain along coincident parts of the two.
  const Regions gained = subtract(with_others, reached(layer.allowed, tol_.uncut / 2), tol_);
  if (gained.empty() && below_.empty()) return std::nullopt;
  const Regions added = intersect(wide, dilate(gained, around, tol_), tol_);
  return below_.empty() ? added : unite(added, below_, tol_);
}

namespace {

/// mm. The area assumed as reached is smaller by the first value than the real one; rests narrower than twice the
/// second are left out: more than the strip left along walls by the first.
constexpr double kSpare = 0.002;
constexpr double kSliver = 0.004;
/// mm. Overlap of the area planned for a rest with areas already cut.
constexpr double kOverlap = 0.05;

/// The area of its own feature cleared by a step's cutter down to z: the whole hole for holes made at once.
Regions reached_by(const Part& part, const Workingstep& step, double z, const Tolerances& tol) {
  const Feature& feature = feature_of(part, step);
  const Tool& tool = tool_of(part, step);
  const double tip = feature.floor_z + step.operation.allowance_floor;
  const bool reaches = tip <= z + tol.coincident && step.operation.kind != OperationKind::kSideFinishing &&
                       !feature.chamfer && feature.kind != FeatureKind::kTSlot && !is_formed(feature);
  if (!reaches) return {};
  if (makes_holes(tool))
    return features::full_depth(part, step) <= z + tol.coincident ? feature.target : Regions{};
  const double narrower = std::max(0.0, tool.radius() - radius_cleared(tool, z - tip));
  return resolve::swept(feature.allowed, tool.radius(), step.operation.allowance_side, -kSpare - narrower,
                        tol);
}

}  // namespace

Regions missed_by_others(int workingstep, const Layer& layer, const ResolvedPlan& plan) {
  const Part& part = plan.part;
  const Tolerances& tol = plan.tol;
  const Box here = box(layer.target);
  Regions left = layer.target;
  for (int i = 0; i < workingstep && !left.empty(); ++i) {
    const Workingstep& step = part.workplan[static_cast<std::size_t>(i)];
    const Feature& other = feature_of(part, step);
    if (!box(other.target).overlaps(here)) continue;
    if (other.wall_slope.radians() != 0) return {};
    left = subtract(left, reached_by(part, step, layer.z, tol), tol);
  }
  if (left.empty()) return left;
  left =
      intersect(left, resolve::swept(layer.allowed, layer.tool_radius, layer.wall_stock, -kSpare, tol), tol);
  const Regions thick = inset(left, kSliver, tol);
  if (thick.empty()) return thick;
  return intersect(dilate(thick, kSliver + kOverlap + 1.5 * layer.wall_stock, tol), layer.target, tol);
}

}  // namespace clearcut::pipeline
