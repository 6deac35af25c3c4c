#include "plan/spiral/spiral.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "geometry/contours/boolean.h"
#include "geometry/route/legal_area.h"
#include "geometry/route/legal_paths.h"
#include "plan/common/clearing_area.h"
#include "plan/common/layers.h"
#include "plan/common/machine_clock.h"
#include "plan/common/residual.h"
#include "plan/common/rings.h"
#include "plan/common/round_corners.h"
#include "plan/contour/step_rule.h"
#include "plan/spiral/turn.h"

namespace clearcut::plan::spiral {
namespace {

/// Tried steps, as shares of the diameter; in large areas only the first ones.
constexpr double kSteps[] = {0.92, 0.86, 0.98, 0.8, 0.74, 0.68, 0.5, 0.35};
/// Number of steps tried in any case; the others are tried only while none has led to a plan.
constexpr std::size_t kUsualSteps = 6;
/// Share of the radius. Steps are chosen to place the innermost turn this far from the deepest point.
constexpr double kMiddle = 0.95;
/// Share of the radius: radius of the arcs in corners.
constexpr double kCorner = 0.6;
/// Share of the radius: corners this near to a residual caused by rounding stay sharp.
constexpr double kSharpReach = 2.5;
/// Share of the radius: how far inside the edge of a face the first turn runs.
constexpr double kInsideEdge = 0.6;
/// Share of the radius: distance between the points of a turn's arcs checked for legality.
constexpr double kLegalPitch = 0.25;
/// Share of the radius: ridges of the medial axis shorter than this are not followed.
constexpr double kLeastRidge = 1;
/// mm. On layers without permitted residual, mending detours overlap by about this.
constexpr double kBareMargin = 0.002;
/// Greatest number of edges of turns over all steps: in large areas few steps are tried.
constexpr double kMostEdgesInAll = 6000;
/// The candidate spirals of one connected area.
struct Spirals {
  std::vector<Path> paths;
  std::vector<int> parents;  ///< index of the enclosing path; -1: none
  double time = std::numeric_limits<double>::infinity();
};

/// An area for spirals. Everything farther than a radius from the rim of `around` has to be cleared.
struct SpiralArea {
  const Region& region;   ///< connected
  bool from_wall = true;  ///< the region's boundary is itself cut
  const Regions& around;
  const Region& legal;  ///< legal area of the tool's centre
};

/// Plans the spirals in one area.
class SpiralPlanner {
 public:
  SpiralPlanner(const SpiralArea& area, const Layer& layer, const SpiralOptions& options,
                const Tolerances& tol)
      : region_(area.region),
        from_wall_(area.from_wall),
        layer_(layer),
        options_(options),
        tol_(tol),
        clearance_(area.region, tol),
        around_(area.around),
        legal_({area.legal}),
        routes_({area.legal}, legal_),
        retract_(options.machine, options.feed, retract_heights(layer)) {
    job_.radius = layer.tool_radius;
    for (const auto& loops : area.around) {
      const auto edges = loops.edges();
      rim_.insert(rim_.end(), edges.begin(), edges.end());
    }
    job_.fixed = rim_;
    if (layer.bare || !from_wall_) job_.residual = -kBareMargin / 2;
    job_.matters = [this](Vec2 p) { return around_.contains(p); };
    if (!from_wall_) first_level_ = level_at_edge();
    job_.legal = [this](Vec2 a, Vec2 b) { return legal_.holds_line(a, b); };
  }
  SpiralPlanner(const SpiralPlanner&) = delete;
  SpiralPlanner& operator=(const SpiralPlanner&) = delete;

  Spirals plan() const {
    Spirals best;
    double work = 0;
    const double narrow = 2 * layer_.tool_radius * kSteps[kUsualSteps - 1];
    for (const double step : steps()) {
      const bool usual = options_.stepover || step > 0.9 * narrow;
      if (!best.paths.empty() && (work > kMostEdgesInAll || !usual)) break;
      auto candidate = spirals(step);
      for (const auto& path : candidate.paths) work += static_cast<double>(path.size());
      if (candidate.time < best.time) best = std::move(candidate);
    }
    return best;
  }

 private:
  /// The steps to try, each also reduced to reach the middle with a whole number of turns.
  std::vector<double> steps() const {
    const double diameter = 2 * layer_.tool_radius;
    std::vector<double> found;
    const auto add = [&](double step) {
      const double path = std::max(0.0, clearance_.max() - kMiddle * layer_.tool_radius - first_level_);
      const double turns = std::ceil(path / step);
      const double even = turns > 0 ? path / turns : step;
      for (const double s : {even, step}) {
        const bool known = std::any_of(found.begin(), found.end(),
                                       [&](double other) { return std::abs(s - other) < 0.005 * diameter; });
        if (!known && s > 0.5 * step) found.push_back(s);
      }
    };
    if (options_.stepover) {
      add(std::min(*options_.stepover, 0.98 * diameter));
    } else {
      for (const double share : kSteps) add(share * diameter);
    }
    return found;
  }

  /// mm from the edge of a face to the first turn: a little inside, but 0 if the face is too narrow.
  double level_at_edge() const {
    const double inside = kInsideEdge * layer_.tool_radius;
    const auto loops = clearance_.inset(inside);
    std::vector<Path> paths = loops_of(loops);
    MendJob job = job_;
    const LegalArea inner(loops);
    job.matters = [&](Vec2 p) { return around_.contains(p) && !inner.contains(p); };
    return !paths.empty() && left_by(paths, job).empty() ? inside : 0;
  }

  Spirals spirals(double step) const {
    auto nodes = ring_tree(
        clearance_, region_, first_level_,
        [&](const RingNode&, const std::vector<AxisPiece>&) { return step; }, tol_);
    if (first_level_ == 0 && !nodes.empty()) nodes.front().contour = region_;
    const auto [chains, chain_of_node] = spiral_chains(nodes);
    Spirals result;
    std::vector<std::size_t> kept;  // for each path: number of unchanged edges at its end
    for (const auto& chain : chains) {
      result.parents.push_back(chain.parent);
      kept.push_back(0);
      result.paths.push_back(spiral(chain, kept.back()));
      if (!from_wall_ || chain.parent >= 0) kept.back() = 0;
    }
    smooth(result.paths, kept);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (auto& ridge : ridges(nodes[i])) {
        result.parents.push_back(chain_of_node[i]);
        result.paths.push_back(std::move(ridge));
      }
    }
    if (!mend(result.paths, job_)) return {};
    result.time = retract_.time_of(result.paths, 2 * layer_.tool_radius);
    return result;
  }

  /// Paths along the ridges left between loops; residuals of a few radii are left to mending.
  std::vector<Path> ridges(const RingNode& node) const {
    std::vector<Path> found;
    for (const auto& ridge : residual_paths(node, layer_.tool_radius - kBareMargin)) {
      Path path;
      for (std::size_t i = 1; i < ridge.points.size(); ++i) {
        if (ridge.points[i] != ridge.points[i - 1])
          path.push_back(Edge::line(ridge.points[i - 1], ridge.points[i]));
      }
      if (ridge.closed) path.push_back(Edge::line(ridge.points.back(), ridge.points.front()));
      if (length(path) > kLeastRidge * layer_.tool_radius) found.push_back(std::move(path));
    }
    return found;
  }

  Loop oriented(const Loop& loop) const { return options_.wall_on_right ? loop : reversed(loop); }

  /// The spiral from the innermost loop outwards; each turn begins at the end of the previous one. `outermost`
  /// returns the number of edges of the last turn and of the rest of the outermost loop.
  Path spiral(const SpiralChain& chain, std::size_t& outermost) const {
    const Loop& innermost = chain.loops.back();
    const auto longest =
        std::max_element(innermost.begin(), innermost.end(),
                         [](const Edge& a, const Edge& b) { return a.length() < b.length(); });
    Path path = lap(oriented(innermost), longest->at(0.5));
    outermost = path.size();
    for (std::size_t i = chain.loops.size() - 1; i-- > 0;) {
      const std::size_t before = path.size();
      const Vec2 at = path.back().to;
      const SpiralTurn turn = turn_to(chain.loops[i], at);
      append(path, turn.path);
      if (turn.path.empty()) {
        append_lap(path, lap(oriented(chain.loops[i]), at));
      } else if (i == 0) {
        const Path around = lap(oriented(chain.loops[0]), path.back().to);
        append(path, beginning(around, std::max(kSpiralFall * length(around), turn.reached)));
      }
      outermost = path.size() - before;
    }
    return path;
  }

  /// Continues with a loop not reached by any turn. If loops differ much from one to the next an island may be
  /// between them: the path to the loop then goes around this island.
  void append_lap(Path& path, const Path& around) const {
    const Vec2 from = path.back().to, to = around.front().from;
    if (!legal_.holds_line(from, to)) {
      if (const auto way = routes_.between(from, to)) append(path, *way);
    }
    append(path, around);
  }

  /// The turn to `loop`; empty if the turn would run into another boundary, for example an island.
  SpiralTurn turn_to(const Loop& loop, Vec2 start) const {
    SpiralTurn turn = turn_inside(loop, start);
    const bool legal =
        std::all_of(turn.path.begin(), turn.path.end(), [this](const Edge& edge) { return is_legal(edge); });
    return legal ? std::move(turn) : SpiralTurn{};
  }

  bool is_legal(const Edge& edge) const {
    if (!edge.is_arc()) return legal_.holds_line(edge.from, edge.to);
    const int count = 1 + static_cast<int>(edge.length() / (kLegalPitch * layer_.tool_radius));
    for (int i = 0; i <= count; ++i) {
      if (!legal_.holds(edge.at(static_cast<double>(i) / count))) return false;
    }
    return true;
  }

  /// Turns are built with the wall on the right; for the other direction everything is mirrored.
  SpiralTurn turn_inside(const Loop& loop, Vec2 start) const {
    if (options_.wall_on_right) return spiral_turn(loop, start);
    Loop mirrored;
    for (const auto& edge : reversed(loop)) mirrored.push_back(mirror(edge));
    SpiralTurn turn = spiral_turn(mirrored, mirror(start));
    for (Edge& edge : turn.path) edge = mirror(edge);
    return turn;
  }

  static Vec2 mirror(Vec2 p) { return {-p.x, p.y}; }
  static Edge mirror(const Edge& edge) {
    const Turn turn = static_cast<Turn>(-static_cast<int>(edge.turn));
    return {mirror(edge.from), mirror(edge.to), mirror(edge.center), turn};
  }

  /// Rounds all corners except in the last `kept` edges of each path, and restores corners whose rounding leaves a
  /// residual.
  void smooth(std::vector<Path>& paths, const std::vector<std::size_t>& kept) const {
    std::vector<Vec2> holes;
    const auto sharp = [&](Vec2 p) {
      return std::any_of(holes.begin(), holes.end(),
                         [&](Vec2 hole) { return distance(hole, p) < kSharpReach * layer_.tool_radius; });
    };
    const auto rounded = [&] {
      std::vector<Path> round;
      for (std::size_t i = 0; i < paths.size(); ++i) {
        const auto cut = paths[i].end() - static_cast<std::ptrdiff_t>(kept[i]);
        round.push_back(with_round_corners(Path(paths[i].begin(), cut), kCorner * layer_.tool_radius, sharp));
        round.back().insert(round.back().end(), cut, paths[i].end());
      }
      return round;
    };
    auto round = rounded();
    holes = left_by(round, job_);
    paths = holes.empty() ? std::move(round) : rounded();
  }

  const Region& region_;
  bool from_wall_;
  double first_level_ = 0;
  const Layer& layer_;
  const SpiralOptions& options_;
  const Tolerances& tol_;
  Clearance clearance_;
  LegalArea around_;
  std::vector<Edge> rim_;
  LegalArea legal_;
  LegalRoutes routes_;
  RetractLink retract_;
  MendJob job_;
};

/// Joins the paths of one legal area in the order of cutting: each after those inside it, the nearest first,
/// by links at depth if these are quicker than a retract link.
class Joiner {
 public:
  Joiner(Spirals spirals, const Region& legal, const Layer& layer, const SpiralOptions& options)
      : spirals_(std::move(spirals)),
        area_({legal}),
        routes_({legal}, area_),
        retract_(options.machine, options.feed, retract_heights(layer)),
        done_(spirals_.paths.size(), false) {}

  std::vector<Path> join() {
    std::vector<Path> joined;
    for (std::size_t i = 0; i < done_.size(); ++i) {
      const auto next = nearest_ready(joined);
      Path path = begun_near(next, joined);
      done_[next] = true;
      auto link = joined.empty()
                      ? std::nullopt
                      : retract_.link_at_depth(joined.back().back().to, path.front().from, routes_);
      if (link) {
        append(joined.back(), *link);
        append(joined.back(), path);
      } else {
        joined.push_back(std::move(path));
      }
    }
    return joined;
  }

 private:
  bool ready(std::size_t i) const {
    if (done_[i]) return false;
    for (std::size_t k = 0; k < done_.size(); ++k) {
      if (!done_[k] && spirals_.parents[k] == static_cast<int>(i)) return false;
    }
    return true;
  }

  bool is_loop(std::size_t i) const { return spirals_.paths[i].front().from == spirals_.paths[i].back().to; }

  /// Path i; a loop begins at the place nearest to the end of the last path.
  Path begun_near(std::size_t i, const std::vector<Path>& joined) const {
    if (joined.empty() || !is_loop(i)) return spirals_.paths[i];
    return lap(spirals_.paths[i], joined.back().back().to);
  }

  std::size_t nearest_ready(const std::vector<Path>& joined) const {
    std::size_t best = done_.size();
    double best_distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < done_.size(); ++i) {
      if (!ready(i)) continue;
      const double d =
          joined.empty() ? 0 : distance(begun_near(i, joined).front().from, joined.back().back().to);
      if (best < done_.size() && d >= best_distance) continue;
      best = i;
      best_distance = d;
    }
    return best;
  }

  Spirals spirals_;
  LegalArea area_;
  LegalRoutes routes_;
  RetractLink retract_;
  std::vector<bool> done_;
};

void add_passes(LayerPasses& result, std::vector<Path> paths, int component, int around,
                double start_priority) {
  for (auto& path : paths) {
    Pass pass;
    pass.path = std::move(path);
    pass.parent = around;
    pass.component = component;
    pass.start_priority = start_priority;
    pass.reversible = false;
    result.passes.push_back(std::move(pass));
  }
}

}  // namespace

LayerPasses plan_spiral(const Layer& layer, const SpiralOptions& options, const Tolerances& tol) {
  CLEARCUT_ASSERT(layer.tool_radius > 0);
  auto area = clearing_area(layer, tol);
  LayerPasses result = std::move(area.walls);
  result.strategy = "spiral";
  std::vector<Pass> walls = std::move(result.passes);
  result.passes.clear();
  const bool pocket = closed_all_round(layer);
  const double first = layer.tool_radius + layer.wall_stock;
  for (std::size_t i = 0; i < area.components.size(); ++i) {
    const auto& [legal, rest, wall] = area.components[i];
    const bool spiral_to_wall = pocket && !rest.empty();
    int outermost = -1;
    for (const auto& pass : walls) {
      if (pass.component != static_cast<int>(i) || spiral_to_wall) continue;
      if (outermost < 0) outermost = static_cast<int>(result.passes.size());
      result.passes.push_back(pass);
    }
    if (spiral_to_wall) {
      const SpiralPlanner planner({legal, true, {legal}, legal}, layer, options, tol);
      add_passes(result, Joiner(planner.plan(), legal, layer, options).join(), static_cast<int>(i), -1,
                 first);
      continue;
    }
    for (const auto& region : rest) {
      const Regions around = dilate({region}, layer.tool_radius, tol);
      const SpiralPlanner planner({region, false, around, legal}, layer, options, tol);
      add_passes(result, Joiner(planner.plan(), legal, layer, options).join(), static_cast<int>(i), outermost,
                 first + layer.tool_radius);
    }
  }
  for (const auto& wall : walls) {
    if (wall.component >= static_cast<int>(area.components.size())) result.passes.push_back(wall);
  }
  round_corners(result, layer.tool_radius, options.feed.mm_per_s(), options.machine.acceleration);
  return result;
}

namespace {

Strategy make(const StrategyRequest& request) {
  SpiralOptions options;
  options.wall_on_right = request.step.wall_on_right();
  options.machine = request.plan.machine;
  options.feed = request.step.feed;
  line_distance(request.stepover,
                1);  // throws for rules without meaning for spirals, before planning begins
  return once_per_outline(
      [options, stepover = request.stepover, tol = request.plan.tol](const Layer& layer) mutable {
        options.stepover = line_distance(stepover, 2 * layer.tool_radius);
        return plan_spiral(layer, options, tol);
      });
}

double least_length(const ClearedSize& size, double radius) {
  return size.reached_mm2 / (2 * radius) + kSpiralFall * size.legal_rim_mm / 2;
}

}  // namespace

StrategyEntry entry() {
  StrategyEntry entry;
  entry.name = "spiral";
  entry.description = "smooth turns from contour to contour, without passages";
  entry.make = make;
  entry.loses_air_cuts = true;
  entry.in_auto = AutoUse::kTried;
  entry.least_length = least_length;
  // Factor on its least time; in 120 random pockets spirals took 1.17 to 2 times the least time.
  entry.margin = 1.15;
  return entry;
}

}  // namespace clearcut::plan::spiral
