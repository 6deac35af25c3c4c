#include "plan/tour/tour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/text.h"
#include "geometry/edge.h"
#include "geometry/route/legal_paths.h"
#include "geometry/voronoi/clearance.h"
#include "plan/common/clearing_area.h"
#include "plan/common/cover.h"
#include "plan/contour/step_rule.h"

namespace clearcut::plan::tour {
namespace {

/// mm. Visits to uncleared places go farther than necessary by this.
constexpr double kReserve = 0.01;
/// Rounds of mending. The first kRerouted change the path; later ones only add detours, so that the process always
/// ends.
constexpr int kRerouted = 3;
constexpr int kMendings = 40;
/// Shares of the radius, and number of directions: the points of a disc tested to decide whether its centre is
/// needed.
constexpr double kProbes[] = {0.45, 0.95};
constexpr int kProbeDirections = 12;

/// A path through the points; for a single point one edge without length.
Path path_through(const Points& points) {
  Path path = line_path(points);
  if (path.empty() && !points.empty()) path.push_back(Edge::line(points.front(), points.front()));
  return path;
}

/// Data common to all areas of a layer.
struct Work {
  const Layer& layer;
  const TourGridOptions& options;
  const TourSolver& solve;
  const Tolerances& tol;
  std::vector<Edge> walls;  ///< the passes along the walls
  LegalArea target;
  bool pocket = true;  ///< the layer is a pocket closed all round

  double radius() const { return layer.tool_radius; }
  double pitch() const { return options.pitch * (options.pitch_in_mm ? 1 : 2 * radius()); }
};

/// A path in one legal area during construction: points joined by straight legal moves.
class Route {
 public:
  explicit Route(const LegalPaths& paths) : paths_(paths) {}

  const Points& points() const { return points_; }

  /// Appends moves to the points in this order. False if the area does not connect two of them; the route then ends
  /// there.
  bool follow(const Points& stops) {
    for (const Vec2 stop : stops) {
      if (!points_.empty()) {
        const auto bends = paths_.bends(points_.back(), stop);
        if (!bends) return false;
        points_.insert(points_.end(), bends->begin(), bends->end());
      }
      points_.push_back(stop);
    }
    return true;
  }

  /// Adds a visit of p at the shortest place: instead of a straight move, or (`beside`) as a detour from the move and
  /// back.
  void visit(Vec2 p, bool beside) {
    if (points_.size() < 2) {
      follow({p});
      return;
    }
    std::vector<std::pair<double, std::size_t>> least;  // lower bound of the length, and index of the move
    for (std::size_t i = 0; i + 1 < points_.size(); ++i)
      least.emplace_back(extra(points_[i], p, points_[i + 1], beside), i);
    std::sort(least.begin(), least.end());
    std::size_t best = 0;
    Points best_path;
    double best_cost = std::numeric_limits<double>::infinity();
    for (const auto& [at_least, i] : least) {
      if (at_least >= best_cost) break;
      const Vec2 a = points_[i], b = points_[i + 1];
      const Points path = detour(a, p, b, beside);
      if (path.empty()) continue;
      const double cost = length_through(a, path, b) - distance(a, b);
      if (cost >= best_cost) continue;
      best = i;
      best_cost = cost;
      best_path = path;
    }
    points_.insert(points_.begin() + static_cast<std::ptrdiff_t>(best) + 1, best_path.begin(),
                   best_path.end());
  }

  Vec2 nearest_to(Vec2 p) const {
    Nearest best{points_.front(), distance(points_.front(), p), 0};
    for (std::size_t i = 1; i < points_.size(); ++i) {
      if (points_[i] == points_[i - 1]) continue;
      const auto candidate = nearest(Edge::line(points_[i - 1], points_[i]), p);
      if (candidate.distance < best.distance) best = candidate;
    }
    return best.point;
  }

 private:
  /// mm; lower bound of the length added by the visit.
  static double extra(Vec2 a, Vec2 p, Vec2 b, bool beside) {
    if (beside) return a == b ? 2 * distance(a, p) : 2 * distance(Edge::line(a, b), p);
    return distance(a, p) + distance(p, b) - distance(a, b);
  }
  /// The points between a and b with the visit; empty if there is no legal path.
  Points detour(Vec2 a, Vec2 p, Vec2 b, bool beside) const {
    const Vec2 foot = a == b ? a : nearest_point(Edge::line(a, b), p);
    const auto there = paths_.bends(beside ? foot : a, p), back = paths_.bends(p, beside ? foot : b);
    if (!there || !back) return {};
    Points path;
    if (beside) path.push_back(foot);
    path.insert(path.end(), there->begin(), there->end());
    path.push_back(p);
    path.insert(path.end(), back->begin(), back->end());
    if (beside) path.push_back(foot);
    return path;
  }
  static double length_through(Vec2 a, const Points& path, Vec2 b) {
    double length = distance(a, path.front()) + distance(path.back(), b);
    for (std::size_t i = 1; i < path.size(); ++i) length += distance(path[i - 1], path[i]);
    return length;
  }

  const LegalPaths& paths_;
  Points points_;
};

/// Choice of the visited points of a lattice: points well inside the rest left by the wall passes, and points
/// clearing a part of the rest that no other point clears.
class GridChoice {
 public:
  GridChoice(const Lattice& lattice, const LegalArea& legal, const LegalArea& rest, double radius)
      : lattice_(lattice),
        legal_(legal),
        rest_(rest),
        radius_(radius),
        chosen_(static_cast<std::size_t>(lattice.columns) * static_cast<std::size_t>(lattice.rows), 0) {}

  void choose(const LegalArea& inside) {
    each([&](int column, int row, Vec2 p) {
      if (inside.contains(p) && legal_.holds(p)) chosen(column, row) = 1;
    });
    each([&](int column, int row, Vec2 p) {
      if (!chosen(column, row) && legal_.holds(p) && is_needed(p, column, row)) chosen(column, row) = 1;
    });
  }

  Points points() const {
    Points points;
    for (int row = 0; row < lattice_.rows; ++row) {
      for (int column = 0; column < lattice_.columns; ++column) {
        if (chosen_[index(column, row)]) points.push_back(lattice_.at(column, row));
      }
    }
    return points;
  }

 private:
  template <typename F>
  void each(F&& f) {
    for (int row = 0; row < lattice_.rows; ++row) {
      for (int column = 0; column < lattice_.columns; ++column) f(column, row, lattice_.at(column, row));
    }
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(lattice_.columns) +
           static_cast<std::size_t>(column);
  }
  char& chosen(int column, int row) { return chosen_[index(column, row)]; }

  /// Whether a cutter at p clears a part of the rest left by the chosen points.
  bool is_needed(Vec2 p, int column, int row) const {
    const auto needs = [&](Vec2 q) { return rest_.contains(q) && !is_cleared(q, column, row); };
    if (needs(p)) return true;
    for (const double share : kProbes) {
      for (int i = 0; i < kProbeDirections; ++i) {
        if (needs(p + direction_of(2 * kPi * i / kProbeDirections) * (share * radius_))) return true;
      }
    }
    return false;
  }

  /// Whether a chosen point near (column, row) clears q.
  bool is_cleared(Vec2 q, int column, int row) const {
    constexpr int kAround = 3;
    for (int r = std::max(0, row - kAround); r <= std::min(lattice_.rows - 1, row + kAround); ++r) {
      for (int c = std::max(0, column - kAround); c <= std::min(lattice_.columns - 1, column + kAround);
           ++c) {
        if (chosen_[index(c, r)] && distance(lattice_.at(c, r), q) <= radius_) return true;
      }
    }
    return false;
  }

  const Lattice& lattice_;
  const LegalArea& legal_;
  const LegalArea& rest_;
  double radius_;
  std::vector<char> chosen_;
};

/// Plans one connected legal area of a layer.
class AreaPlanner {
 public:
  AreaPlanner(const ClearingComponent& component, const Work& work)
      : legal_(component.legal), rest_(component.rest), work_(work), paths_({legal_}), route_(paths_) {}

  /// The path through the grid and all other points to be visited; empty if there are none.
  Path plan() {
    if (rest_.empty() && !work_.options.published) return {};
    follow(grid());
    for (int round = 0; !work_.options.published && round < kMendings; ++round) {
      const Points left = holes();
      if (left.empty()) break;
      mend(left, round >= kRerouted);
    }
    return path_through(route_.points());
  }

 private:
  Points grid() const {
    if (work_.options.published)
      return points_in(published_lattice(published_box(), work_.pitch()), paths_.area());
    const Regions inside = well_inside();
    const Lattice lattice = filling(fitted_lattice(box(inside.empty() ? rest_ : inside), work_.pitch()),
                                    box(rest_).grown(work_.radius()));
    const LegalArea rest(rest_);
    GridChoice choice(lattice, paths_.area(), rest, work_.radius());
    choice.choose(LegalArea(inside));
    return choice.points();
  }

  /// The legal area's box; on open sides, on which the area is practically unlimited, the box ends a radius beyond
  /// the target, like the box of "a pocket with slightly larger dimensions" (7.6), a diameter larger all round.
  Box published_box() const {
    const Box legal = legal_.box(), near = box(work_.layer.target).grown(work_.radius());
    return {{std::max(legal.min.x, near.min.x), std::max(legal.min.y, near.min.y)},
            {std::min(legal.max.x, near.max.x), std::min(legal.max.y, near.max.y)}};
  }

  /// The rest without a rim. A point between the rim and the first row, half a pitch from the nearest points
  /// of this row, is just within a radius of these.
  Regions well_inside() const {
    const double radius = work_.radius(), half = std::min(work_.pitch() / 2, radius);
    const double margin = 0.98 * std::sqrt(radius * radius - half * half) - 0.02 * radius;
    if (margin <= 0) return rest_;
    Regions inside;
    for (const auto& region : rest_) {
      const Regions pieces = inset(region, margin, work_.tol);
      inside.insert(inside.end(), pieces.begin(), pieces.end());
    }
    return inside;
  }

  void follow(const Points& points) {
    if (points.empty()) return;
    TourTask task;
    task.points = points;
    task.pitch = work_.pitch();
    task.layer = &work_.layer;
    const LegalPaths::Between between(paths_, points);
    if (!paths_.all_straight())
      task.path = [&](int a, int b) { return between.bends(a, b).value_or(Points{}); };
    Points stops;
    for (const int i : points.size() > 1 ? work_.solve(task) : std::vector<int>{0})
      stops.push_back(points[i]);
    CLEARCUT_ASSERT(stops.size() == points.size());
    route_.follow(stops);
  }

  /// Points of the target cleared neither by the wall passes nor by the path.
  Points holes() const {
    std::vector<Edge> edges = work_.walls;
    for (const auto& edge : path_through(route_.points())) {
      if (edge.from != edge.to) edges.push_back(edge);
    }
    if (edges.empty()) return {};
    const Cover cover(edges, work_.radius());
    const auto matters = [&](Vec2 p) { return paths_.area().contains(p) && work_.target.contains(p); };
    Points found = cover.holes(matters);
    if (work_.pocket) return found;
    // Beside open sides the target's own boundary may bound a hole.
    for (const auto& region : rest_) {
      for (const auto& edge : region.edges()) add_left_of(edge, edges, cover, found);
    }
    return found;
  }

  /// Adds the middle of every uncleared part of an edge. Parts end at crossings of the edge with the rim of a sweep.
  void add_left_of(const Edge& edge, const std::vector<Edge>& swept, const Cover& cover,
                   Points& found) const {
    std::vector<double> cuts{0, 1};
    const Box near = edge.box().grown(work_.radius());
    for (const auto& path : swept) {
      if (!path.box().overlaps(near)) continue;
      for (const auto& side : rim_of(path)) {
        for (const Vec2 p : intersections(edge, side)) cuts.push_back(nearest(edge, p).t);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      if ((cuts[i] - cuts[i - 1]) * edge.length() < work_.tol.uncut / 10) continue;
      const Vec2 p = edge.at((cuts[i - 1] + cuts[i]) / 2);
      if (paths_.area().contains(p) && !cover.holds(p, -work_.tol.uncut / 10)) found.push_back(p);
    }
  }

  /// The boundary of the area swept along an edge.
  std::vector<Edge> rim_of(const Edge& path) const {
    const double radius = work_.radius();
    std::vector<Edge> rim;
    const auto add_circle = [&](Vec2 center, double r) {
      const Vec2 east = center + Vec2{r, 0}, west = center - Vec2{r, 0};
      rim.push_back(Edge::arc(east, west, center, Turn::kCounterClockwise));
      rim.push_back(Edge::arc(west, east, center, Turn::kCounterClockwise));
    };
    add_circle(path.from, radius);
    add_circle(path.to, radius);
    if (path.is_arc()) {
      add_circle(path.center, path.radius() + radius);
      if (path.radius() > radius) add_circle(path.center, path.radius() - radius);
      return rim;
    }
    const Vec2 across = left_of(path.tangent_at(0)) * radius;
    rim.push_back(Edge::line(path.from + across, path.to + across));
    rim.push_back(Edge::line(path.from - across, path.to - across));
    return rim;
  }

  /// Visits every hole; one visit clears all holes within reach. With `beside` visits are detours as far in
  /// as the hole's rim, to avoid clearing a long thin hole in many small steps.
  void mend(Points left, bool beside) {
    if (route_.points().empty()) return follow(thinned(left));
    while (!left.empty()) {
      const Vec2 place = beside ? left.front() : place_for(left);
      route_.visit(place, beside);
      const Vec2 first = left.front();
      const double reach = work_.radius() - kReserve / 2;
      std::erase_if(left, [&](Vec2 p) { return p == first || distance(p, place) < reach; });
    }
  }

  /// A subset of the points with every other point within half a radius of one of them.
  Points thinned(const Points& points) const {
    Points kept;
    for (const Vec2 p : points) {
      const bool near =
          std::any_of(kept.begin(), kept.end(), [&](Vec2 q) { return distance(p, q) < work_.radius() / 2; });
      if (!near) kept.push_back(p);
    }
    return kept;
  }

  /// The centre position clearing the first hole and the holes around it, as near to the path as possible. If their
  /// middle does not clear all of them, the hole is large and its rim is visited.
  Vec2 place_for(const Points& left) const {
    const double radius = work_.radius();
    Points group;
    Vec2 middle{};
    for (const Vec2 p : left) {
      if (distance(p, left.front()) < 2 * radius) group.push_back(p), middle = middle + p;
    }
    middle = middle / static_cast<double>(group.size());
    const auto serves = [&](Vec2 place) {
      return paths_.area().holds(place) && std::all_of(group.begin(), group.end(), [&](Vec2 p) {
               return distance(p, place) <= radius - kReserve;
             });
    };
    if (!serves(middle)) return left.front();
    const Vec2 foot = route_.nearest_to(middle);
    double low = 0, high = 1;
    for (int i = 0; i < 20; ++i) {
      const double t = (low + high) / 2;
      (serves(lerp(middle, foot, t)) ? low : high) = t;
    }
    return lerp(middle, foot, low);
  }

  const Region& legal_;
  const Regions& rest_;
  const Work& work_;
  LegalPaths paths_;
  Route route_;
};

}  // namespace

TourGridOptions parse_tour_grid(const std::string& text) {
  const plan::contour::StepRule rule = plan::contour::parse_step_rule(text);
  TourGridOptions options;
  if (rule.kind == plan::contour::StepRule::Kind::kFraction) {
    options.pitch = rule.value;
  } else if (rule.kind == plan::contour::StepRule::Kind::kMm) {
    options.pitch = rule.value;
    options.pitch_in_mm = true;
  } else if (rule.kind != plan::contour::StepRule::Kind::kWidest) {
    throw InputError("--stepover", fmt::format("'{}' has no meaning for a grid; use 0.7 or 3.5mm", text));
  }
  return options;
}

namespace {

/// Whether the passes leave something in reach, at walls too.
bool leaves_something(const LayerPasses& passes, double tool_radius) {
  return !passes.passes.empty() && (leaves_border(passes, tool_radius, tool_radius + kBorderResidual) ||
                                    !leaves_nothing(passes, tool_radius));
}

/// The published grid begins in one corner, is not stretched, and has no passes along walls (Tour 4.2.4).
Remark rest_of_rule(double pitch) {
  return {"RIM OF THE PUBLISHED GRID",
          fmt::format(
              "what stays here is left by the rule of the published grid (Tour eq. 4.8): points {} mm apart "
              "from one "
              "corner on, and no pass along walls; plan once more with --after this program to cut it, or "
              "leave --grid out",
              trimmed(pitch, 3))};
}

}  // namespace

LayerPasses plan_tour(const Layer& layer, const TourGridOptions& options, const TourSolver& solve,
                      const Tolerances& tol) {
  auto area = clearing_area(layer, tol);
  LayerPasses result = std::move(area.walls);
  result.strategy = "tour";
  Work work{layer, options, solve, tol, {}, LegalArea(layer.target), closed_all_round(layer)};
  for (const auto& pass : result.passes) {
    std::copy_if(pass.path.begin(), pass.path.end(), std::back_inserter(work.walls),
                 [](const Edge& edge) { return edge.from != edge.to; });
  }
  if (options.published) {
    result.passes.clear();
    result.residual = std::max(result.residual, work.pitch());  // the rim
  }
  for (std::size_t i = 0; i < area.components.size(); ++i) {
    Pass pass;
    pass.path = AreaPlanner(area.components[i], work).plan();
    if (pass.path.empty()) continue;
    pass.parent = options.published ? -1 : area.components[i].outer_wall;
    pass.component = static_cast<int>(i);
    result.passes.push_back(std::move(pass));
  }
  if (options.published && leaves_something(result, layer.tool_radius))
    result.remarks.push_back(rest_of_rule(work.pitch()));
  return result;
}

}  // namespace clearcut::plan::tour
