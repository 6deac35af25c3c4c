#include "plan/adaptive/adaptive.h"

#include <algorithm>
#include <cmath>

#include "base/progress.h"
#include "geometry/boolean.h"
#include "geometry/clearance.h"
#include "plan/adaptive/clearing_outline.h"
#include "plan/adaptive/entry_regions.h"
#include "plan/adaptive/finish/finish.h"
#include "plan/adaptive/trace/wall_cuts.h"

namespace clearcut::plan::adaptive {
namespace {

/// Radians. What rounding in the program, arcs fitted to traced curves and the sampling of the contact may add.
constexpr double kContactMargin = 0.003;
/// Radius of the entry circle as a share of the cutter's: below 1 no post is left in its middle.
constexpr double kEntryCircle = 0.95;
constexpr double kNoLimit = 1e300;  // mm
/// Tool radii between the marks on walls.
constexpr double kMarkPitch = 0.1;
/// Tool radii that clearing keeps off the walls, for what arcs deviate from the curves they are fitted to.
constexpr double kKeepOff = 0.0035;
/// Entries for what the cuts from elsewhere cannot reach.
constexpr int kMostEntries = 20;
/// Rests that are cut one by one: of an area that is cleared by then; and where nothing else clears it.
constexpr int kFewRests = 60;
constexpr int kMostRests = 2000;
/// Tool radii that the centre may run beyond an open side.
constexpr double kBeyondOpenSides = 1.01;
/// Tool radii between the places beside the stock from where cuts are tried, how far inside their outline these are, and
/// how near the stock is there.
constexpr double kAirPitch = 0.5;
constexpr double kBesideAir = 0.005;
constexpr double kNearStock = 0.05;
/// Tool radii of wall without contact that end a cut while clearing.
constexpr double kAir = 0.3;
/// Tool radii beside corners that clearing leaves to the arcs between their walls, from where cuts from wall to wall come nearer
/// by less and less: this less how much nearer each arc ends.
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
double film_between_cuts(double radius, double limit) {
  const double step = radius * (1 - std::cos(limit));
  return std::max(0.16 * step * step / radius, radius * (1 - std::cos(limit / 3)));
}

/// Where cuts may begin that no free way leads to.
enum class Lifts {
  kFew,  ///< from above only where all else is cut, and not often
  kAny   ///< as often as it takes: in areas so large that free ways do not lead back round them
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
        ground_({legal}, radius_, layer.stock),
        ways_(clearance.axis(), layer.tool_radius + layer.wall_stock, 2 * radius_),
        path_(ground_, ways_),
        finder_(front_, clearance, ground_, layer, limit, options.start),
        clearing_(ground_, path_, {front_, legal, kMarkPitch * radius_, film_between_cuts(radius_, limit)},
                  inner.clearing, limit, {kAir * radius_, 0}),
        finish_(ground_, path_, legal, inner.finishing, layer.target, limit),
        open_(layer.stock && has_open_side(layer)),
        lifts_(lifts),
        cancel_(options.cancel) {
    leave_corners();
    for (const PredrilledHole& hole : layer.holes) ground_.remove_disc(hole.center, hole.diameter / 2);
  }

  /// Absent where more was left to the end than is cut one by one.
  std::optional<std::vector<Pass>> plan() {
    if (open_) cut_from_outside();
    clear_rooms();
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
  void clear_rooms() {
    const auto rooms = finder_.choose();
    for (std::size_t i = 0; i < rooms.size(); ++i) {
      clear_room(rooms[i]);
      cut_fronts([&](Vec2 p) { return nearest_room(rooms, p) == i; });
    }
    cut_fronts(everywhere);
  }

  /// In at open sides, as far as that leads.
  void cut_from_outside() {
    clearing_.walls.update(ground_, legal_.box());
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
      before = ground_.cuts();
      path_.finish_pass();
      cut_fronts(everywhere);
      if (ground_.cuts() == before) break;
    }
    path_.resume_pass();
  }

  /// Round the stock with it on the right, nearer until the contact is at the limit, and on. Whether it stands beside
  /// the outline at s, with nothing on it.
  bool cut_from_air(const Wall& outline, double s) {
    const Vec2 along = outline.heading(s), inwards = left_of(along),
               p = outline.at(s) + inwards * (kBesideAir * radius_);
    if (ground_.touches(p, Ground::kClear) ||
        !ground_.touches(p + inwards * (kNearStock * radius_), Ground::kFree))
      return false;
    const auto way = path_.empty() ? std::nullopt : path_.way_to(p, Ground::kFree);
    const Path cut = finish_.cut_on(p, -along);
    if (cut.empty()) return false;
    path_.append(cut, way ? *way : path_.hop_to(p));
    clearing_.walls.update(ground_, box(cut).grown(2 * radius_));
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
      const auto room = finder_.widest_uncut();
      if (!room) return;
      clear_room(*room);
      cut_fronts(everywhere);
    }
  }

  /// A spiral in the room, and on round it. A last thin turn of the spiral would waste most of a round; it is needed only
  /// where no cut leads on without it.
  void clear_room(const Disc& room) {
    path_.open(room, entry_circle_, limit_, finder_.hole_at(room.center));
    const Walls walls = clearing_.walls;
    const std::size_t spiral = ground_.cuts();
    Path round = go_round();
    if (!leads_on()) {
      ground_.forget_beyond(spiral);
      clearing_.walls = walls;
      path_.widen_to_rim(room, limit_);
      round = go_round();
    }
    path_.append(round, {});
  }

  /// On from the last turn of the spiral.
  Path go_round() {
    const auto last = path_.last_arc();
    Path round = last ? clearing_.tracer.cut_on(last->to, last->tangent_at(1), 1 / last->radius()) : Path{};
    clearing_.walls.update(ground_, legal_.box());
    return round;
  }

  /// Whether a cut can be made from a wall.
  bool leads_on() {
    const std::size_t before = ground_.cuts();
    const auto starts = clearing_.walls.starts();
    return std::any_of(starts.begin(), starts.end(), [&](const WallPlace& start) {
      const Path cut = clearing_.tracer.cut_from(start, start.s);
      ground_.forget_beyond(before);
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
  Ground ground_;
  FreeWays ways_;
  ClearingPath path_;
  RoomFinder finder_;
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
  const double limit = options.engagement.radians() - kContactMargin;
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
