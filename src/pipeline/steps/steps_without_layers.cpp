#include "pipeline/steps/steps_without_layers.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "base/elementary.h"
#include "base/tolerances.h"
#include "features/round_hole.h"
#include "geometry/contours/boolean.h"
#include "geometry/region.h"
#include "geometry/voronoi/clearance.h"
#include "link/hole.h"
#include "link/moves.h"
#include "link/tracks.h"
#include "pipeline/steps/certify.h"
#include "plan/carve/carve.h"
#include "plan/carve/chamfer.h"
#include "plan/common/layers.h"
#include "post/post.h"

namespace clearcut::pipeline {
namespace {

/// mm. Ridges that a pointed bit may leave on a floor out of reach of mills; less than the certificate allows.
constexpr double kCusp = 0.03;
/// mm. Reduction of the flanks' distance from the outline by chords of the medial axis.
constexpr double kChords = 0.0004;
/// mm. Reduction of the distance from a wall by offsets and booleans.
constexpr double kOffsets = 0.001;

/// The part of a V-carving's floor cleared by the mills of earlier steps.
Regions cleared_before(int workingstep, const Region& region, const ResolvedPlan& plan) {
  const Part& part = plan.part;
  const Workingstep& own = part.workplan[static_cast<std::size_t>(workingstep)];
  const Feature& feature = feature_of(part, own);
  const double foot = (feature.top_z - feature.floor_z) * base::tan(feature.wall_slope.radians());
  Regions cleared;
  for (int i = 0; i < workingstep; ++i) {
    const Workingstep& step = part.workplan[static_cast<std::size_t>(i)];
    if (step.feature != own.feature || !clears_floors(tool_of(part, step))) continue;
    const double radius = tool_of(part, step).radius(), flat = radius - tool_of(part, step).corner_radius;
    const Regions centers = inset(region, foot + radius + step.operation.allowance_side, plan.tol);
    if (!centers.empty()) cleared = unite(cleared, dilate(centers, flat, plan.tol), plan.tol);
  }
  return cleared;
}

/// Distances of a flank from material not to be cut. Kept minimal: in sharp corners several times this distance is left.
class Aside {
 public:
  /// `share`: of the distance by which the rounding of digits may displace the flank.
  Aside(double slope, double share, const ResolvedPlan& plan)
      : slope_(slope), share_(share), spare_(0.9 * plan.tol.gouge) {}

  /// mm; for tips that are printed to `rounding` mm.
  double for_rounding(double rounding) const {
    return kChords + share_ * std::max(0.0, rounding * (1 + slope_) - spare_);
  }

 private:
  double slope_, share_, spare_;
};

/// The free area up to every height at which material ends, from the top of a chamfer on.
std::vector<plan::carve::StandingUpTo> standing_above(const Feature& feature, const ResolvedPlan& plan) {
  const Part& part = plan.part;
  std::set<double> heights{feature.top_z, part.top_z()};
  for (const Feature& other : part.features) heights.insert(other.top_z);
  std::vector<plan::carve::StandingUpTo> out;
  for (const double z : heights) {
    if (z < feature.top_z) continue;
    Regions free;
    if (part.stock) {
      const Box& block = part.stock->plan;
      free = {frame_around(block, kOpenReach)};
    }
    for (const Feature& other : part.features) {
      if (other.floor_z < z && other.kind != FeatureKind::kTSlot && !other.allowed.empty())
        free = free.empty() ? other.allowed : unite(free, other.allowed, plan.tol);
    }
    out.push_back({z, std::move(free)});
  }
  return out;
}

plan::carve::TrackSets chamfer_tracks(const Feature& feature, const Tool& tool, double stepdown,
                                      double reserve_share, const ResolvedPlan& plan) {
  plan::carve::ChamferShape shape;
  shape.top = feature.top_z;
  shape.slope = flank_slope(tool);
  shape.tip_radius = tool.tip_diameter / 2;
  shape.tool_radius = tool.radius();
  shape.aside = kOffsets + Aside(shape.slope, reserve_share, plan).for_rounding(post::rounding_of(plan.post));
  shape.stepdown = stepdown;
  return plan::carve::chamfer_edge(*feature.chamfer, shape, standing_above(feature, plan), plan.tol).sets;
}

plan::carve::CarveShape carve_shape(const Feature& feature, const Tool& tool, double stepdown,
                                    double reserve_share, const ResolvedPlan& plan) {
  plan::carve::CarveShape shape;
  shape.top = feature.top_z;
  shape.floor = feature.floor_z;
  shape.slope = flank_slope(tool);
  shape.tip_radius = tool.tip_diameter / 2;
  const Aside aside(shape.slope, reserve_share, plan);
  shape.aside = aside.for_rounding(post::rounding_of_lines(plan.post));
  shape.arcs_aside = aside.for_rounding(post::rounding_of(plan.post)) - shape.aside;
  shape.stepdown = stepdown;
  shape.cusp = kCusp;
  return shape;
}

/// mm. Rounding of distances between a straight move and an outline at the least permitted distance.
constexpr double kRounding = 1e-7;

/// A straight move is free if the cone, with its tip at that height, fits between the outlines along the whole move.
/// Below the first pass the move must be short: at its beginning the cone has cut all material except that of one
/// pass.
link::TipRoom room_within(const Regions& target, const plan::carve::CarveShape& shape) {
  const auto holds = [&target, shape](Vec2 from, Vec2 to, double z) {
    const double needed = shape.tip_radius + shape.aside + (shape.top - z) * shape.slope - kRounding;
    const Edge way = Edge::line(from, to);
    return std::any_of(target.begin(), target.end(), [&](const Region& region) {
      const auto edges = region.edges();
      return region.contains(from) && std::all_of(edges.begin(), edges.end(), [&](const Edge& edge) {
               return distance(edge, way) >= needed;
             });
    });
  };
  return {holds, shape.top - shape.stepdown, shape.tip_radius + shape.stepdown * shape.slope};
}

/// The tracks of the tip, and the room for crossing from one track to the next.
struct Tracks {
  plan::carve::TrackSets sets;
  link::TipRoom room;
};

Tracks tracks_of(int workingstep, double reserve_share, const ResolvedPlan& plan) {
  const Workingstep& step = plan.part.workplan[static_cast<std::size_t>(workingstep)];
  const Feature& feature = feature_of(plan.part, step);
  const Tool& tool = tool_of(plan.part, step);
  const double stepdown = plan.steps[static_cast<std::size_t>(workingstep)].stepdown;
  if (feature.chamfer) return {chamfer_tracks(feature, tool, stepdown, reserve_share, plan), {}};
  if (feature.profile)
    return {plan::carve::engrave_line(feature.profile->line, feature.profile->closed, feature.top_z,
                                      feature.floor_z, stepdown),
            {}};
  const auto shape = carve_shape(feature, tool, stepdown, reserve_share, plan);
  Tracks tracks;
  for (const Region& region : feature.target) {
    for (auto& set :
         plan::carve::carve_region(region, shape, cleared_before(workingstep, region, plan), plan.tol))
      tracks.sets.push_back(std::move(set));
  }
  tracks.room = room_within(feature.target, shape);
  return tracks;
}

}  // namespace

std::optional<Section> carve_step(int workingstep, double reserve_share, const ResolvedPlan& plan) {
  const Workingstep& step = plan.part.workplan[static_cast<std::size_t>(workingstep)];
  if (!is_carved(feature_of(plan.part, step), tool_of(plan.part, step))) return std::nullopt;
  const link::LinkOptions link =
      link_options(plan, workingstep, plan.steps[static_cast<std::size_t>(workingstep)].entry);
  Tracks tracks = tracks_of(workingstep, reserve_share, plan);
  Section section =
      link::link_tracks(std::move(tracks.sets), plan.part.top_z() + link.above_material, link, tracks.room);
  describe(section, workingstep, plan);
  return section;
}

namespace {

/// Pitches above the material at which a tap begins to feed, but at least 2 mm: the spindle then has reached its
/// speed.
constexpr double kPitchesAbove = 3;
constexpr double kLeastAboveTap = 2;
/// mm; distance of a mill from a thread's diameter in addition to its displacement by coarse digits.
constexpr double kOffThread = 0.0005;

double tip_of_cone(const Feature& feature, const Tool& tool) {
  return feature.top_z - (feature.hole->diameter / 2 - tool.tip_diameter / 2) / flank_slope(tool);
}

/// mm; distance kept by a place displaced by up to `rounding` mm: half of the smallest gouge remains. 0 if the
/// displacement is less than a gouge.
double kept_off(double rounding, const ResolvedPlan& plan) {
  return rounding <= plan.tol.gouge ? 0 : rounding - plan.tol.gouge / 2;
}

/// mm; rise of a hole's bottom, so that coarse digits put no tap or tip lower than half of the smallest gouge. 0 if
/// the digits' error is smaller.
double raise_of_depth(const ResolvedPlan& plan) {
  return kept_off(post::rounding_of_lines(plan.post) * std::sqrt(0.5), plan);  // along one axis
}

/// mm; rise of a cone for the same reason: rounding of its place moves its flanks nearer, and so does that of its depth.
double raise_of_cone(const Tool& tool, const ResolvedPlan& plan) {
  const double slope = flank_slope(tool);
  const double nearer = post::rounding_of_lines(plan.post) + post::rounding_of_heights(plan.post) * slope;
  return kept_off(nearer, plan) / slope;
}

link::ThreadWork thread_work(const Feature& feature, const Tool& tool, double off) {
  const HoleForm& hole = *feature.hole;
  link::ThreadWork work;
  work.center = hole.center;
  work.external = hole.external;
  work.radius = hole.external ? root_diameter(*hole.thread) / 2 + off : hole.diameter / 2 - off;
  work.crest = hole.diameter / 2;
  work.aside = approach_beside(*hole.thread);
  work.pitch = hole.thread->pitch;
  work.left_hand = hole.thread->left_hand;
  work.z_top = feature.top_z;
  work.full_z = hole.full_z;
  if (tool.pitch > 0 && tool.flute_length)
    work.rows = std::max(1.0, std::floor(*tool.flute_length / tool.pitch + 1e-9)) * hole.thread->pitch;
  return work;
}

}  // namespace

std::optional<Section> formed_hole_step(int workingstep, const ResolvedPlan& plan) {
  const Workingstep& step = plan.part.workplan.at(static_cast<std::size_t>(workingstep));
  const Feature& feature = feature_of(plan.part, step);
  if (!is_formed(feature)) return std::nullopt;
  const Tool& tool = tool_of(plan.part, step);
  link::LinkOptions link = link_options(plan, workingstep, EntryKind::kPlunge);
  const HoleForm& hole = *feature.hole;
  Section section;
  if (hole.kind == HoleKind::kTapped) {
    link.above_material = std::max(kLeastAboveTap, kPitchesAbove * tool.pitch);
    section = link::feed_out_hole(
        {hole.center, tool.radius(), feature.top_z, feature.floor_z + raise_of_depth(plan)}, link);
  } else if (hole.kind == HoleKind::kThreadMilled) {
    section = link::mill_thread(thread_work(feature, tool, kOffThread + post::rounding_of(plan.post)), link);
  } else {
    const double tip = tip_of_cone(feature, tool) + raise_of_cone(tool, plan);
    section = link::drill_hole({hole.center, tool.radius(), feature.top_z, tip}, feature.top_z - tip, link);
  }
  describe(section, workingstep, plan);
  return section;
}

namespace {

/// What a layer keeps off the wall for a cutter's rounded end is cut by its side.
link::HoleWork work_of(const features::RoundHole& hole, const std::vector<Layer>& layers) {
  const double stock = layers.back().wall_stock - layers.back().rounded;
  return {hole.center, hole.radius - stock, layers.front().z_top, layers.back().z};
}

bool is_drilled(const features::RoundHole& hole, const ResolvedStep& step, const Tool& tool,
                const Tolerances& tol) {
  if (makes_holes(tool)) return tool.radius() <= hole.radius + tol.fit;
  return tool.center_cutting && step.allowance_side == 0 && features::makes_hole(tool, hole, tol);
}

/// Whether a layer was widened into features that remove some of the hole's wall: no stock may be left there.
bool runs_into_others(const std::vector<Layer>& layers, const Feature& feature) {
  return std::any_of(layers.begin(), layers.end(),
                     [&](const Layer& layer) { return !plan::same_outline(layer.allowed, feature.allowed); });
}

bool is_bored(const link::HoleWork& work, const Feature& feature, const ResolvedStep& step,
              const Tool& tool) {
  return step.strategy == nullptr && feature.kind == FeatureKind::kRoundHole && !step.is_plunge_asked &&
         link::can_bore(work, tool.radius(), flat_end(tool) > 0 ? flat_end(tool) : tool.radius());
}

}  // namespace

std::optional<Section> hole_step(const std::vector<Layer>& layers, int workingstep,
                                 const ResolvedPlan& plan) {
  const ResolvedStep& step = plan.steps.at(static_cast<std::size_t>(workingstep));
  const auto& planned = plan.part.workplan.at(static_cast<std::size_t>(workingstep));
  const auto& feature = feature_of(plan.part, planned);
  const auto& tool = tool_of(plan.part, planned);
  const auto hole = features::round_hole_of(feature, plan.tol);
  std::optional<Section> section;
  if (hole && !layers.empty()) {
    const link::HoleWork work = work_of(*hole, layers);
    const link::LinkOptions link = link_options(plan, workingstep, step.entry_at_limit);
    if (is_drilled(*hole, step, tool, plan.tol) &&
        !features::leaves_hole_undone(plan.part, planned, plan.tol)) {
      const bool chips = feature.hole && feature.hole->chip_break;
      const bool feeds_out =
          tool.kind == ToolKind::kReamer ||
          (feature.hole && (feature.hole->kind == HoleKind::kReamed || tool.kind == ToolKind::kBoringBar));
      section = feeds_out ? link::feed_out_hole(work, link)
                : chips   ? link::chip_hole(work, step.stepdown, link)
                          : link::drill_hole(work, step.stepdown, link,
                                             planned.operation.hole_feeds.value_or(HoleFeeds{}));
    } else if (is_bored(work, feature, step, tool) && !runs_into_others(layers, feature)) {
      section = link::bore_hole(work, step.stepdown, link);
    }
  }
  if (!section && makes_holes(tool)) section = Section{};
  if (section) describe(*section, workingstep, plan);
  return section;
}

namespace {

/// The feed of a move without a stated one.
MmPerMin usual_feed(MoveKind kind, const link::LinkOptions& link) {
  switch (kind) {
    case MoveKind::kRapid:
      return MmPerMin::of(0);
    case MoveKind::kPlunge:
      return link.plunge_feed;
    case MoveKind::kRamp:
      return link.ramp_feed;
    case MoveKind::kLeadIn:
    case MoveKind::kLeadOut:
      return link.lead_feed.value_or(link.feed);
    case MoveKind::kCut:
    case MoveKind::kLink:
    case MoveKind::kRetract:
      break;
  }
  return link.feed;
}

/// Writes the moves of one path with the lifts between them.
class StatedMoves {
 public:
  /// `top_z`: top of all remaining material.
  StatedMoves(const StatedMove& first, double top_z, const link::LinkOptions& link)
      : link_(link), top_z_(top_z), moves_(first.path.from, std::max(link.safe_z, first.z_from)) {}

  void add(const StatedMove& move) {
    const bool goes_on = distance(move.path.from, moves_.at()) <= kSamePlaceMm &&
                         std::abs(move.z_from - moves_.z()) <= kSamePlaceMm;
    if (!goes_on) go_over(move.path.from, move.z_from);
    const MmPerMin feed = move.feed.value_or(usual_feed(move.kind, link_));
    Edge path = move.path;
    path.from = moves_.at();
    if (move.path.from == move.path.to) path.to = path.from;
    moves_.append({{path, moves_.z(), move.z_to, move.kind, feed, 0}});
    ++count_;
    if (move.dwell_s > 0) dwells_.push_back({count_ - 1, move.dwell_s});
  }

  Section finished() {
    if (moves_.z() < link_.safe_z) rapid(link_.safe_z);
    Section section;
    section.moves = moves_.take();
    section.dwells = std::move(dwells_);
    return section;
  }

 private:
  void rapid(double z) {
    if (z == moves_.z()) return;
    moves_.vertical(z, MoveKind::kRapid, MmPerMin::of(0));
    ++count_;
  }
  void go_over(Vec2 to, double z) {
    rapid(std::max({link_.safe_z, z, moves_.z()}));
    if (to != moves_.at()) {
      moves_.line(to, MoveKind::kRapid, MmPerMin::of(0));
      ++count_;
    }
    rapid(std::max(z, std::min({link_.cross_z, link_.safe_z, top_z_ + link_.above_material})));
    if (z == moves_.z()) return;
    moves_.vertical(z, MoveKind::kPlunge, link_.plunge_feed);
    ++count_;
  }

  const link::LinkOptions& link_;
  double top_z_;
  link::MoveList moves_;
  std::vector<Dwell> dwells_;
  std::size_t count_ = 0;
};

}  // namespace

std::optional<Section> stated_step(int workingstep, const ResolvedPlan& plan) {
  const StatedPath* path = path_of(plan.part.workplan.at(static_cast<std::size_t>(workingstep)));
  if (path == nullptr) return std::nullopt;
  Section section;
  if (!path->moves.empty()) {
    const link::LinkOptions link = link_options(plan, workingstep, EntryKind::kPlunge);
    StatedMoves moves(path->moves.front(), plan.part.top_z(), link);
    for (const StatedMove& move : path->moves) moves.add(move);
    section = moves.finished();
  }
  describe(section, workingstep, plan);
  return section;
}

std::optional<Section> t_slot_step(int workingstep, const ResolvedPlan& plan) {
  const Workingstep& step = plan.part.workplan[static_cast<std::size_t>(workingstep)];
  const Feature& feature = feature_of(plan.part, step);
  if (!feature.t_slot) return std::nullopt;
  Path way = feature.profile->line;
  if (!feature.t_slot->leaves_at_end) {
    const Path back = reversed(way);
    way.insert(way.end(), back.begin(), back.end());
  }
  // Coarse digits put the tip no lower than half of the smallest gouge.
  const double z = feature.floor_z + std::max(0.0, post::rounding_of_heights(plan.post) - plan.tol.gouge / 2);
  Track track;
  for (const Edge& edge : way) track.pieces.push_back({edge, z, z});
  std::vector<std::vector<Track>> sets{{std::move(track)}};
  const link::LinkOptions link =
      link_options(plan, workingstep, plan.steps[static_cast<std::size_t>(workingstep)].entry);
  Section section = link::link_tracks(std::move(sets), plan.part.top_z() + link.above_material, link);
  describe(section, workingstep, plan);
  return section;
}

}  // namespace clearcut::pipeline
