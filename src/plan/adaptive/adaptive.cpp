#include "plan/adaptive/adaptive.h"

#include <algorithm>
#include <cmath>

#include "base/progress.h"
#include "geometry/boolean.h"
#include "geometry/clearance.h"
#include "plan/adaptive/clearing_outline.h"
#include "plan/adaptive/entry_regions.h"
#include "plan/adaptive/finish/finish.h"
#include "plan/adaptive/parameters.h"
#include "plan/adaptive/trace/wall_cuts.h"

namespace clearcut::plan::adaptive {
namespace {

/// Radius of the entry circle as a share of the cutter's: below 1, so that no post is left in its middle.
constexpr double kEntryCircle = 0.95;
/// mm: the entry circle may be as wide as it likes.
constexpr double kNoLimit = 1e300;
/// Tool radii that clearing keeps off the walls, for what arcs deviate from the curves they are fitted to.
constexpr double kKeepOff = 0.0035;
/// Entries into what cuts from elsewhere cannot reach.
constexpr int kMostEntries = 20;
/// Rests that are cut one by one: in an area that other cuts have cleared, and where nothing else clears it.
constexpr int kFewRests = 60;
constexpr int kMostRests = 2000;
/// Tool radii that the centre may run beyond an open side: just past the place where the cutter leaves the stock.
constexpr double kBeyondOpenSides = 1.01;
/// Tool radii between the places beside the stock from which cuts are tried; how far inside their outline these lie; and how
/// near to them there must be stock.
constexpr double kAirPitch = 0.5;
constexpr double kBesideAir = 0.005;
constexpr double kNearStock = 0.05;
/// Tool radii of wall beside a corner that clearing leaves to the arcs between the corner's walls: kLeftToCorner less the gain
/// of each arc (cuts from wall to wall come nearer to the corner by less and less), and kLeastLeft at least.
constexpr double kLeftToCorner = 1.5;
constexpr double kLeastLeft = 0.7;

/// Whether the cutter may be far beside what is to be removed.
bool has_open_side(const Layer& layer) {
  const Box reach = box(layer.target).grown(layer.tool_radius), allowed = box(layer.allowed);
  return !reach.contains(allowed.min) || !reach.contains(allowed.max);
}

/// Where the cutter may be, less what lies far beyond open sides: there it cuts air.
Regions area_near_target(const Layer& layer, const Tolerances& tol) {
  if (!has_open_side(layer)) return layer.allowed;
  const double reach = (1 + kBeyondOpenSides) * layer.tool_radius + layer.wall_stock;
  return intersect(layer.allowed, dilate(layer.target, reach, tol), tol);
}

/// Where traced cuts may run: `clearing` beside what a wall pass takes later, `finishing` beside the walls.
struct InnerAreas {
  Regions clearing;
  Regions finishing;
};

/// mm. What cuts that end at a wall leave between them.
double residual_between_cuts(double radius, double limit) {
  const double step = radius * (1 - std::cos(limit));
  return std::max(0.16 * step * step / radius, radius * (1 - std::cos(limit / 3)));
}

/// Where cuts may begin that no free path leads to.
enum class Lifts {
  kFew,  ///< from above only where all else is cut, and not often
  kAny   ///< as often as it takes: in areas so large that free paths do not lead back round them
};

/// The passes of one connected legal area.
class AdaptivePlanner {
 public:
  AdaptivePlanner(const Region& legal, const InnerAreas& inner, const Clearance& clearance,
                  const Layer& layer, double limit, const AdaptiveOptions& options, Lifts lifts)
      : legal_(legal),
        front_(front_area(legal, layer.tool_radius, limit)),
        radius_(layer.tool_radius),
        limit_(limit),
        entry_circle_(std::min(kEntryCircle * radius_, options.widest_helix.value_or(kNoLimit) / 2)),
        remaining_({legal}, radius_, layer.stock),
        links_(clearance.axis(), layer.tool_radius + layer.wall_stock, 2 * radius_),
        path_(remaining_, links_),
        finder_(front_, clearance, remaining_, layer, limit, options.start),
        clearing_(remaining_, path_,
                  {front_, legal, RadiusShares::kWallPitch * radius_, residual_between_cuts(radius_, limit)},
                  inner.clearing, limit, {RadiusShares::kAir * radius_, 0}),
        finish_(remaining_, path_, legal, inner.finishing, layer.target, limit),
        open_(layer.stock && has_open_side(layer)),
        lifts_(lifts),
        cancel_(options.cancel) {
    leave_corners();
    for (const PredrilledHole& hole : layer.holes) remaining_.remove_disc(hole.center, hole.diameter / 2);
  }

  /// Absent where more was left to the end than is cut one by one.
  std::optional<std::vector<Pass>> plan() {
    if (open_) cut_from_outside();
    clear_entry_regions();
    enter_what_is_left();
    if (!finish_.run(open_, lifts_ == Lifts::kFew ? kFewRests : kMostRests) && lifts_ == Lifts::kFew)
      return std::nullopt;
    return path_.take_passes();
  }

 private:
  static bool everywhere(Vec2) { return true; }

  /// To the arcs between their walls, where no other corner is near. Cuts from open sides begin at what is cut of the walls.
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

  /// The widest places one after the other, each with what is nearer to it than to the others.
  void clear_entry_regions() {
    const auto entry_regions = finder_.choose();
    for (std::size_t i = 0; i < entry_regions.size(); ++i) {
      clear_entry_region(entry_regions[i]);
      cut_fronts([&](Vec2 p) { return nearest_entry_region(entry_regions, p) == i; });
    }
    cut_fronts(everywhere);
  }

  /// In at open sides, as far as that leads.
  void cut_from_outside() {
    clearing_.walls.update(remaining_, legal_.box());
    cut_fronts_from_above();
    const Wall outline(legal_.outer());
    const double end = outline.length();
    for (double s = 0; s < end; s += kAirPitch * radius_) {
      if (cut_from_air(outline, s)) cut_fronts_from_above();
    }
  }

  /// Cuts from wall to wall; where lifts are free, from above, too, until that leads to no more.
  void cut_fronts_from_above() {
    cut_fronts(everywhere);
    if (lifts_ == Lifts::kFew) return;
    for (std::size_t before = 0; !path_.empty() && !clearing_.walls.starts().empty();) {
      before = remaining_.cuts();
      path_.finish_pass();
      cut_fronts(everywhere);
      if (remaining_.cuts() == before) break;
    }
    path_.resume_pass();
  }

  /// Round the stock with it on the right, nearer until the engagement is at the limit, and on. Whether it stands beside
  /// the outline at s, with nothing on it.
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

  /// What the cuts could not reach is entered from above.
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

  /// A spiral in the entry region, and on round it. A last thin turn of the spiral would waste most of a round; it is needed only
  /// where no cut leads on without it.
  void clear_entry_region(const Disc& entry_region) {
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
  }

  /// On from the last turn of the spiral.
  Path go_round() {
    const auto last = path_.last_arc();
    Path round = last ? clearing_.tracer.cut_on(last->to, last->tangent_at(1), 1 / last->radius()) : Path{};
    clearing_.walls.update(remaining_, legal_.box());
    return round;
  }

  /// Whether a cut can be made from a wall.
  bool leads_on() {
    const std::size_t before = remaining_.cuts();
    const auto starts = clearing_.walls.starts();
    return std::any_of(starts.begin(), starts.end(), [&](const WallPlace& start) {
      const Path cut = clearing_.tracer.cut_from(start, start.s);
      remaining_.forget_beyond(before);
      return length(cut) > radius_;
    });
  }

  /// Cuts from wall to wall, the nearest start first, until no wall that is wanted touches material. What
  /// cannot be reached now is tried again after everything else.
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
  Region front_;  ///< where it clears; the rest is the wall pass's
  double radius_, limit_;
  double entry_circle_;  ///< radius of the first circle, mm
  RemainingStock remaining_;
  ClearLinks links_;
  ClearingPath path_;
  EntryRegionFinder finder_;
  WallCuts clearing_;
  AdaptiveFinish finish_;
  bool open_;  ///< something beside the target is free
  Lifts lifts_;
  std::stop_token cancel_;
};

/// With few lifts, else with as many as it takes.
std::vector<Pass> passes_of(const Region& legal, const InnerAreas& inner, const Clearance& clearance,
                            const Layer& layer, double limit, const AdaptiveOptions& options) {
  for (const Lifts lifts : {Lifts::kFew, Lifts::kAny}) {
    auto passes = AdaptivePlanner(legal, inner, clearance, layer, limit, options, lifts).plan();
    if (passes) return std::move(*passes);
  }
  return {};
}

/// The passes of one legal area, to run one after the other.
void add_passes(LayerPasses& result, std::vector<Pass> passes) {
  const auto first = static_cast<int>(result.passes.size()), count = static_cast<int>(passes.size());
  for (int i = 0; i < count; ++i) {
    Pass& pass = passes[static_cast<std::size_t>(i)];
    pass.parent = i + 1 < count ? first + i + 1 : -1;
    pass.component = first;
    pass.offset = count - i;
    result.passes.push_back(std::move(pass));
  }
}

/// The areas where traced cuts may run, of each region of `legal`.
std::vector<InnerAreas> inner_areas(const Regions& legal, const Clearance& clearance, const Layer& layer,
                                    double limit) {
  std::vector<InnerAreas> areas(legal.size());
  for (const Region& region : clearance.inset(layer.tool_radius * (1 + kKeepOff) + layer.wall_stock)) {
    const Vec2 p = region.outer().front().from;
    const auto in = std::find_if(legal.begin(), legal.end(), [&](const Region& r) { return r.contains(p); });
    if (in == legal.end()) continue;
    InnerAreas& inner = areas[static_cast<std::size_t>(in - legal.begin())];
    inner.clearing.push_back(front_area(region, layer.tool_radius, limit));
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

}  // namespace

LayerPasses plan_adaptive(const Layer& layer, const AdaptiveOptions& options, const Tolerances& tol) {
  LayerPasses result;
  result.z_top = layer.z_top;
  result.z = layer.z;
  result.target = layer.target;
  result.strategy = "adaptive";
  const double first = layer.tool_radius + layer.wall_stock;
  const double limit = options.engagement.radians() - EngagementTolerance::kMargin;
  for (const auto& region : area_near_target(layer, tol)) {
    const Clearance clearance(region, tol);
    auto legal = clearance.inset(first);
    const auto inner = inner_areas(legal, clearance, layer, limit);
    for (std::size_t i = 0; i < legal.size(); ++i) {
      add_passes(result, passes_of(legal[i], inner[i], clearance, layer, limit, options));
      result.legal.push_back(std::move(legal[i]));
    }
    add_fit_lines(result, clearance.fit_lines(first, layer.reserve));
  }
  return result;
}

}  // namespace clearcut::plan::adaptive
