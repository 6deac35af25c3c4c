#include "plan/adaptive/adaptive.h"

#include <algorithm>
#include <utility>

#include "base/elementary.h"
#include "base/progress.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"
#include "plan/adaptive/clearing/clearing_outline.h"
#include "plan/adaptive/clearing/clearing_path.h"
#include "plan/adaptive/clearing/parameters.h"
#include "plan/adaptive/entry_regions.h"
#include "plan/adaptive/finish/finish.h"
#include "plan/adaptive/smooth_links.h"
#include "plan/adaptive/trace/wall_cuts.h"
#include "plan/common/clearing_area.h"
#include "plan/common/layers.h"

namespace clearcut::plan::adaptive {
namespace {

/// Radius of the entry circle as a share of the tool radius: below 1, so that no post stays in its middle.
constexpr double kEntryCircle = 0.95;
/// mm: the entry circle may be of any width.
constexpr double kNoLimit = 1e300;
/// Share of the tool radius: clearing keeps this distance from the walls, because arcs deviate from the
/// curves that they are fitted to.
constexpr double kKeepOff = 0.0035;
/// Greatest number of entries into what cuts from elsewhere cannot reach.
constexpr int kMostEntries = 20;
/// Greatest number of rests that are cut one by one: kFewRests at the first attempt, kMostRests at the last.
constexpr int kFewRests = 60;
constexpr int kMostRests = 2000;
/// Share of the tool radius: how far the centre may go beyond an open side, just past the place where the
/// cutter leaves the stock.
constexpr double kBeyondOpenSides = 1.01;
/// Shares of the tool radius, for cuts that begin beside the stock: distance between the places that are
/// tried, their distance inside the outline of the legal area, and how near to them stock must be.
constexpr double kAirPitch = 0.5;
constexpr double kBesideAir = 0.005;
constexpr double kNearStock = 0.05;
/// Share of the tool radius by which loops over an area cleared before overlap, and stay off its border.
constexpr double kOverlap = 0.005;
/// Shares of the tool radius: length of wall on both sides of a corner that clearing leaves to the arcs between
/// the corner's walls. It is kLeftToCorner less arc_gain(), which is near 1 where many arcs would be needed, but
/// at least kLeastLeft.
constexpr double kLeftToCorner = 1.5;
constexpr double kLeastLeft = 0.7;

/// Whether the cutter's centre may be farther than its radius outside of the target.
bool has_open_side(const Layer& layer) {
  const Box reach = box(layer.target).grown(layer.tool_radius), allowed = box(layer.allowed);
  return !reach.contains(allowed.min) || !reach.contains(allowed.max);
}

/// Greatest engagement that cuts from open sides aim at: with the centre inside of the edge, on which wider cuts run, they leave
/// material behind them on the open side.
const Radians kMostFromOutside = Radians::of_degrees(90);
/// The same for what earlier steps have left. Cuts aimed at far more than a pass along a thin strip of it would be engaged run straight at
/// the wall and end there: they aim at this many times as much, within bounds, and thick rests at what a pass along them would be.
constexpr double kTimesAlongStrip = 2.5;
const Radians kLeastIntoRest = Radians::of_degrees(45), kMostIntoRest = Radians::of_degrees(70);

/// mm; mean width of strips.
double mean_width(const Regions& strips) {
  double rim = 0;
  for (const Loop& loop : loops_of(strips)) rim += length(loop);
  return rim > 0 ? 2 * area(strips) / rim : 0;
}

/// Radians; greatest engagement that cuts of a cutter of `radius` mm into `strips` aim at.
double most_into_rest(const Regions& strips, double radius) {
  const double along = engagement_along_wall(radius, mean_width(strips));
  const double into_strip =
      std::clamp(kTimesAlongStrip * along, kLeastIntoRest.radians(), kMostIntoRest.radians());
  return std::max(into_strip, std::min(along, kMostFromOutside.radians()));
}

/// A layer as its cuts are planned.
struct CutLayer {
  Layer layer;
  bool open = false;          ///< beside stock: cuts come in from outside
  double floor_radius = 0;    ///< mm; of the flat part of the cutter's end
  double limit = 0;           ///< radians; the engagement that cuts aim at
  std::vector<Loop> cleared;  ///< along which a cutter of this radius has cut before
};

/// Beside open sides the material has not been cut before, so that a cutter with rounded corners meets its edge with its whole radius:
/// cuts are planned with that. In closed areas the flat part of its end meets what earlier cuts have left on the floor.
/// `most_from_outside`: radians; greatest engagement that cuts from open sides aim at.
CutLayer cut_layer(const Layer& layer, bool open, double most_from_outside, const AdaptiveOptions& options) {
  CutLayer cut{layer,
               open,
               layer.tool_radius,
               options.engagement.radians() * options.limit_share - EngagementTolerance::kMargin,
               {}};
  if (!cut.open) return cut;
  cut.layer.tool_radius += layer.rounded;
  cut.layer.wall_stock -= layer.rounded;
  cut.limit = std::min(cut.limit, most_from_outside * options.limit_share);
  return cut;
}

/// Where the cutter may be, without what lies far beyond open sides, where it would cut air.
Regions area_near_target(const Layer& layer, const Tolerances& tol) {
  if (!has_open_side(layer)) return layer.allowed;
  const double reach = (1 + kBeyondOpenSides) * layer.tool_radius + layer.wall_stock;
  return intersect(layer.allowed, dilate(layer.target, reach, tol), tol);
}

/// Where traced cuts may run: `clearing` keeps off what a wall pass cuts later, `finishing` reaches up to the
/// walls.
struct InnerAreas {
  Regions clearing;
  Regions finishing;
};

/// mm; thickness of the residual that stays on a wall between two cuts that end there.
double residual_between_cuts(double radius, double limit) {
  const double step = radius * (1 - base::cos(limit));
  return std::max(0.16 * step * step / radius, radius * (1 - base::cos(limit / 3)));
}

/// How often cuts may begin from above, when no clear link leads to where they begin.
enum class Retracts {
  kFew,  ///< only where all else is cut, and a limited number of times
  kAny   ///< at any time: for areas so large that clear links do not lead back round them
};

/// Plans the passes of one connected legal area.
class AdaptivePlanner {
 public:
  AdaptivePlanner(const Region& legal, const InnerAreas& inner, const Clearance& clearance,
                  const CutLayer& cut, const AdaptiveOptions& options, Retracts retracts)
      : legal_(legal),
        front_(front_area(legal, cut.layer.tool_radius, cut.limit)),
        radius_(cut.layer.tool_radius),
        limit_(cut.limit),
        entry_circle_(std::min(kEntryCircle * radius_, options.widest_helix.value_or(kNoLimit) / 2)),
        remaining_({legal}, radius_, cut.layer.stock),
        clock_(options.clock),
        links_(clearance.axis(), radius_ + cut.layer.wall_stock, 2 * radius_),
        path_(remaining_, links_),
        pictures_(options.pictures, legal, path_),
        finder_(front_, clearance, remaining_, cut.layer, limit_, options.start),
        clearing_(remaining_, path_,
                  {front_, legal, RadiusShares::kWallPitch * radius_, residual_between_cuts(radius_, limit_)},
                  inner.clearing, limit_, {RadiusShares::kAir * radius_, 0}),
        finish_(remaining_, path_,
                {legal, inner.finishing, cut.layer.target, limit_, cut.floor_radius, options.clock}),
        open_(cut.open),
        retracts_(retracts),
        cancel_(options.cancel) {
    leave_corners();
    for (const Loop& way : cut.cleared)
      for (const Edge& edge : way) remaining_.cut(edge);
    for (const PredrilledHole& hole : cut.layer.holes) remaining_.remove_disc(hole.center, hole.diameter / 2);
    uncut_ = remaining_.cuts();
  }

  /// All passes. With Retracts::kFew nothing, if more rests are left at the end than are cut one by one.
  std::optional<std::vector<Pass>> plan() {
    if (open_) cut_from_outside();
    clear_entry_regions();
    enter_what_is_left();
    pictures_.after("cuts from wall to wall");
    if (!finish_.run(open_, retracts_ == Retracts::kFew ? kFewRests : kMostRests, pictures_) &&
        retracts_ == Retracts::kFew)
      return std::nullopt;
    auto passes = path_.take_passes();
    remaining_.forget_beyond(uncut_);
    smooth_links(passes, remaining_, clock_);
    for (Pass& pass : passes)
      straighten_wide_arcs(pass, {remaining_.legal(), ResidualLimits::kWall, ResidualLimits::kWall});
    return passes;
  }

 private:
  static bool everywhere(Vec2) { return true; }

  /// Leaves the walls beside corners, where no other corner is near, to the arcs between the corner's walls.
  /// Cuts from open sides need more of the walls.
  void leave_corners() {
    const auto corners = corners_of(clearing_.walls, limit_);
    const auto places = places_of(corners);
    for (const Corner& corner : corners) {
      const double left = open_ ? kLeastLeft : kLeftToCorner - arc_gain(corner.turn, limit_);
      const double reach = std::max(left, kLeastLeft) * radius_;
      if (clearing_.walls.is_alone(corner.place, places, 2 * reach))
        clearing_.walls.leave_out({corner.place, reach, reach});
    }
  }

  /// Clears the entry regions one after the other, each with the material that is nearer to it than to the
  /// others.
  void clear_entry_regions() {
    const auto entry_regions = finder_.choose();
    for (std::size_t i = 0; i < entry_regions.size(); ++i) {
      clear_entry_region(entry_regions[i]);
      cut_fronts([&](Vec2 p) { return nearest_entry_region(entry_regions, p) == i; });
    }
    cut_fronts(everywhere);
  }

  /// Cuts inwards from open sides until nothing more can be cut from there.
  void cut_from_outside() {
    clearing_.walls.update(remaining_, legal_.box());
    cut_fronts_from_above();
    cut_from_air(legal_.outer());
    for (const Loop& island : legal_.islands()) cut_from_air(island);
  }

  void cut_from_air(const Loop& loop) {
    const Wall outline(loop);
    const double end = outline.length();
    for (double s = 0; s < end; s += kAirPitch * radius_) {
      if (cut_from_air(outline, s)) cut_fronts_from_above();
    }
  }

  /// Cuts from wall to wall. If retracts are free, also from above, until nothing more can be cut.
  void cut_fronts_from_above() {
    cut_fronts(everywhere);
    if (retracts_ == Retracts::kFew) return;
    for (std::size_t before = 0; !path_.empty() && !clearing_.walls.starts().empty();) {
      before = remaining_.cuts();
      path_.finish_pass();
      cut_fronts(everywhere);
      if (remaining_.cuts() == before) break;
    }
    path_.resume_pass();
  }

  /// A cut that begins beside the stock, with the stock on the right, and turns towards it until the engagement
  /// is at the limit. True if it was made: that needs a clear place on the outline at s with stock beside it.
  bool cut_from_air(const Wall& outline, double s) {
    const Vec2 along = outline.heading(s), inwards = left_of(along),
               p = outline.at(s) + inwards * (kBesideAir * radius_);
    if (remaining_.touches(p, RemainingStock::kClear) ||
        !remaining_.touches(p + inwards * (kNearStock * radius_), RemainingStock::kFree))
      return false;
    const auto link = path_.empty() ? std::nullopt : path_.link_to(p, RemainingStock::kFree);
    const Path cut = finish_.cut_on(p, -along);
    if (cut.empty()) return false;
    path_.append(cut, link ? *link : path_.retract_to(p));
    clearing_.walls.update(remaining_, box(cut).grown(2 * radius_));
    return true;
  }

  /// Enters from above what the cuts could not reach.
  void enter_what_is_left() {
    for (int i = 0; i < kMostEntries && !clearing_.walls.starts().empty() && !path_.empty(); ++i) {
      path_.finish_pass();
      cut_fronts(everywhere);
    }
    path_.resume_pass();
    for (int i = 0; i < kMostEntries; ++i) {
      const auto entry_region = finder_.widest_uncut();
      if (!entry_region) return;
      clear_entry_region(*entry_region);
      cut_fronts(everywhere);
    }
  }

  /// A spiral in the entry region and a cut that goes on from it. A last thin turn of the spiral mostly cuts
  /// air, so it is added only if no cut leads on without it.
  void clear_entry_region(const Disc& entry_region) {
    pictures_.after("cuts from wall to wall");
    if (const auto stroke = finder_.stroke_in_passage(entry_region)) {
      path_.open_along(*stroke);
      clearing_.walls.update(remaining_, legal_.box());
      return;
    }
    path_.open(entry_region, entry_circle_, limit_, finder_.hole_at(entry_region.center));
    const Walls walls = clearing_.walls;
    const std::size_t spiral = remaining_.cuts();
    Path round = go_round();
    if (!leads_on()) {
      remaining_.forget_beyond(spiral);
      clearing_.walls = walls;
      path_.widen_to_rim(entry_region, limit_);
      round = go_round();
    }
    path_.append(round, {});
    pictures_.after("spiral");
  }

  /// A cut that goes on from the last turn of the spiral.
  Path go_round() {
    const auto last = path_.last_arc();
    Path round = last ? clearing_.tracer.cut_on(last->to, last->tangent_at(1), 1 / last->radius()) : Path{};
    clearing_.walls.update(remaining_, legal_.box());
    return round;
  }

  /// Whether a cut can be made from some wall. Trial cuts are taken back.
  bool leads_on() {
    const std::size_t before = remaining_.cuts();
    const auto starts = clearing_.walls.starts();
    return std::any_of(starts.begin(), starts.end(), [&](const WallPlace& start) {
      const Path cut = clearing_.tracer.cut_from(start, start.s);
      remaining_.forget_beyond(before);
      return length(cut) > radius_;
    });
  }

  /// Cuts from wall to wall, the nearest start first, until no wall for which `wanted` is true touches
  /// material. Starts that no link leads to are tried again after everything else.
  template <typename Wanted>
  void cut_fronts(const Wanted& wanted) {
    std::vector<WallPlace> unreached;
    for (bool cut_since = false;;) {
      throw_if_cancelled(cancel_);
      auto starts = clearing_.walls.starts();
      std::erase_if(starts, [&](const WallPlace& start) {
        return !wanted(clearing_.walls.point(start)) ||
               std::find(unreached.begin(), unreached.end(), start) != unreached.end();
      });
      if (starts.empty()) {
        if (unreached.empty() || !cut_since) return;
        unreached.clear();
        cut_since = false;
        continue;
      }
      const WallPlace start = clearing_.nearest(starts);
      if (clearing_.cut_from(start)) {
        cut_since = true;
      } else {
        unreached.push_back(start);
      }
    }
  }

  const Region& legal_;
  Region front_;  ///< where clearing runs; the rest of `legal` is left to the wall pass
  double radius_, limit_;
  double entry_circle_;  ///< mm; radius of an entry's first circle
  RemainingStock remaining_;
  std::size_t uncut_ = 0;  ///< the state of the stock before the first cut
  const MachineClock& clock_;
  ClearLinks links_;
  ClearingPath path_;
  StepPictures pictures_;
  EntryRegionFinder finder_;
  WallCuts clearing_;
  AdaptiveFinish finish_;
  bool open_;  ///< the target has open sides
  Retracts retracts_;
  std::stop_token cancel_;
};

/// Plans with few retracts and, if that leaves more than kFewRests rests, again with any number of them.
std::vector<Pass> passes_of(const Region& legal, const InnerAreas& inner, const Clearance& clearance,
                            const CutLayer& cut, const AdaptiveOptions& options) {
  for (const Retracts retracts : {Retracts::kFew, Retracts::kAny}) {
    auto passes = AdaptivePlanner(legal, inner, clearance, cut, options, retracts).plan();
    if (passes) return std::move(*passes);
  }
  return {};
}

/// Adds the passes of one legal area, to be run in this order.
void add_passes(LayerPasses& result, std::vector<Pass> passes) {
  const auto first = static_cast<int>(result.passes.size()), count = static_cast<int>(passes.size());
  for (int i = 0; i < count; ++i) {
    Pass& pass = passes[static_cast<std::size_t>(i)];
    if (i > 0) pass.after = {first + i - 1};
    pass.component = first;
    pass.start_priority = count - i;
    result.passes.push_back(std::move(pass));
  }
}

/// For each region of `legal`, the areas where traced cuts may run.
std::vector<InnerAreas> inner_areas(const Regions& legal, const Clearance& clearance, const CutLayer& cut) {
  std::vector<InnerAreas> areas(legal.size());
  for (const Region& region :
       clearance.inset(cut.layer.tool_radius * (1 + kKeepOff) + cut.layer.wall_stock)) {
    const Vec2 p = region.outer().front().from;
    const auto in = std::find_if(legal.begin(), legal.end(), [&](const Region& r) { return r.contains(p); });
    if (in == legal.end()) continue;
    InnerAreas& inner = areas[static_cast<std::size_t>(in - legal.begin())];
    inner.clearing.push_back(front_area(region, cut.layer.tool_radius, cut.limit));
    inner.finishing.push_back(region);
  }
  return areas;
}

void add_fit_lines(LayerPasses& result, const std::vector<Path>& lines) {
  for (const auto& line : lines) {
    Pass pass;
    pass.path = line;
    pass.closed = line.size() > 1 && line.front().from == line.back().to;
    pass.component = static_cast<int>(result.passes.size());
    pass.may_cut_to_start = false;
    result.passes.push_back(std::move(pass));
    result.fit_lines.push_back(line);
  }
}

/// Parts of the target so far from each other that the cutter meets one at a time.
std::vector<Regions> parts_apart(const Regions& target, double apart) {
  std::vector<Regions> parts;
  for (const Region& region : target) {
    Regions part{region};
    const Box near = region.box().grown(apart);
    std::erase_if(parts, [&](const Regions& other) {
      const bool joins = std::any_of(other.begin(), other.end(),
                                     [&](const Region& one) { return one.box().overlaps(near); });
      if (joins) part.insert(part.end(), other.begin(), other.end());
      return joins;
    });
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Loops along which a cutter of `radius` clears an area, without corners that it does not reach.
std::vector<Loop> ways_over(const Regions& area, double radius, const Tolerances& tol) {
  std::vector<Loop> ways;
  for (double away = radius * (1 + kOverlap);; away += 2 * radius * (1 - kOverlap)) {
    const Regions centers = inset(area, away, tol);
    if (centers.empty()) return ways;
    for (Loop& loop : loops_of(centers)) ways.push_back(std::move(loop));
  }
}

/// What earlier steps have left, part by part: each is cut from the sides that it has towards what they have cut.
std::vector<CutLayer> cuts_of_rest(const Layer& layer, const AdaptiveOptions& options,
                                   const Tolerances& tol) {
  std::vector<CutLayer> cuts;
  // Above the rounding of its corners a cutter takes what its whole radius reaches.
  const double radius = layer.tool_radius + layer.rounded;
  const double reach = (1 + kBeyondOpenSides) * radius + layer.wall_stock - layer.rounded;
  for (Regions& part : parts_apart(layer.target, 2 * reach)) {
    Layer one = layer;
    one.stock = box(part);
    one.allowed = intersect(layer.allowed, dilate(part, reach, tol), tol);
    const Regions around = intersect(layer.allowed, dilate(part, reach + radius, tol), tol);
    const Regions cleared = subtract(around, part, tol);
    const Regions centers = inset(one.allowed, layer.tool_radius + layer.wall_stock, tol);
    const Regions strips = intersect(part, dilate(centers, radius, tol), tol);
    one.target = std::move(part);
    CutLayer cut = cut_layer(one, true, most_into_rest(strips, radius), options);
    cut.cleared = ways_over(cleared, cut.layer.tool_radius, tol);
    cuts.push_back(std::move(cut));
  }
  return cuts;
}

/// Adds the passes of one layer, or of one part of it.
void add_layer(const CutLayer& cut, const AdaptiveOptions& options, const Tolerances& tol,
               LayerPasses& result) {
  const double first = cut.layer.tool_radius + cut.layer.wall_stock;
  for (const auto& region : area_near_target(cut.layer, tol)) {
    const Clearance clearance(region, tol);
    auto legal = clearance.inset(first);
    const auto inner = inner_areas(legal, clearance, cut);
    for (std::size_t i = 0; i < legal.size(); ++i) {
      add_passes(result, passes_of(legal[i], inner[i], clearance, cut, options));
      result.legal.push_back(std::move(legal[i]));
    }
    add_fit_lines(result, clearance.fit_lines(first, cut.layer.reserve));
  }
}

}  // namespace

LayerPasses plan_adaptive(const Layer& layer, const AdaptiveOptions& options, const Tolerances& tol) {
  LayerPasses result;
  result.z_top = layer.z_top;
  result.z = layer.z;
  result.target = layer.target;
  result.strategy = "adaptive";
  if (layer.rest && options.rest_alone) {
    for (const CutLayer& part : cuts_of_rest(layer, options, tol)) add_layer(part, options, tol, result);
  } else {
    add_layer(cut_layer(layer, layer.stock && has_open_side(layer), kMostFromOutside.radians(), options),
              options, tol, result);
  }
  return result;
}

namespace {

Strategy make(const StrategyRequest& request, const ClockOf& clock_of) {
  AdaptiveOptions options;
  options.clock = clock_of(request);
  if (request.step.aimed_engagement_deg)
    options.engagement = Radians::of_degrees(*request.step.aimed_engagement_deg);
  if (request.plan.engagement_deg) options.engagement = Radians::of_degrees(*request.plan.engagement_deg);
  options.limit_share = request.limit_share;
  // A second attempt is made where the first was not certified clean.
  options.rest_alone = request.limit_share >= 1;
  options.start = request.plan.start;
  options.cancel = request.plan.cancel;
  options.widest_helix = request.step.helix_widest;
  return once_per_outline(
      [options, tol = request.plan.tol](const Layer& layer) { return plan_adaptive(layer, options, tol); });
}

double least_length(const ClearedSize& size, double radius) {
  return size.reached_mm2 / (radius * (1 - base::cos(AdaptiveOptions{}.engagement.radians())));
}

}  // namespace

StrategyEntry entry(ClockOf clock_of) {
  StrategyEntry entry;
  entry.name = "adaptive";
  entry.description = "engagement limited, spiral and arcs";
  entry.make = [clock_of = std::move(clock_of)](const StrategyRequest& request) {
    return make(request, clock_of);
  };
  entry.in_auto = AutoUse::kTried;
  entry.limits_engagement = true;
  entry.takes_stepover = false;
  entry.least_length = least_length;
  return entry;
}

}  // namespace clearcut::plan::adaptive
