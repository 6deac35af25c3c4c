#include "plan/tour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "geometry/clearance.h"
#include "geometry/line_path.h"
#include "plan/contour.h"
#include "plan/contour_cover.h"
#include "plan/legal_ways.h"

namespace clearcut {
namespace {

/// mm. Visits to what is left reach this much farther than they must.
constexpr double kReserve = 0.01;
/// Rounds of mending that reroute the way; those after only add to it, which always ends.
constexpr int kRerouted = 3;
constexpr int kMendings = 40;
/// Radii, and directions, of the places of a disc that are asked whether they need it.
constexpr double kProbes[] = {0.45, 0.95};
constexpr int kProbeDirections = 12;

using Points = std::vector<Vec2>;

/// A single point stays, as a way of no length.
Path way_through(const Points& points) {
  Path path = line_path(points);
  if (path.empty() && !points.empty()) path.push_back(Edge::line(points.front(), points.front()));
  return path;
}

struct Lattice {
  Vec2 corner;
  double pitch = 0;
  int columns = 0, rows = 0;

  Vec2 at(int column, int row) const { return corner + Vec2{column * pitch, row * pitch}; }
};

int steps_in(double extent, double pitch) {
  return static_cast<int>(std::floor(extent / pitch + 1e-9));
}

/// From the box's lower left corner, as published.
Lattice published_lattice(const Box& box, double pitch) {
  return {box.min, pitch, steps_in(box.width(), pitch) + 1, steps_in(box.height(), pitch) + 1};
}

/// Stretched down so that the wider side is met at both ends, in the middle of the other.
Lattice fitted_lattice(const Box& box, double largest) {
  const double wide = std::max(box.width(), box.height());
  const double pitch = wide / std::max(1.0, std::ceil(wide / largest - 1e-9));
  Lattice lattice = published_lattice(box, pitch > 0 ? pitch : largest);
  const auto centred = [&](double low, double extent, int count) {
    return low + (extent - (count - 1) * lattice.pitch) / 2;
  };
  lattice.corner = {centred(box.min.x, box.width(), lattice.columns),
                    centred(box.min.y, box.height(), lattice.rows)};
  return lattice;
}

/// The same lattice with as many more columns and rows as it takes to fill `box`.
Lattice filling(const Lattice& lattice, const Box& box) {
  const int left = std::max(0, steps_in(lattice.corner.x - box.min.x, lattice.pitch));
  const int below = std::max(0, steps_in(lattice.corner.y - box.min.y, lattice.pitch));
  return {lattice.at(-left, -below), lattice.pitch,
          steps_in(box.max.x - lattice.corner.x, lattice.pitch) + left + 1,
          steps_in(box.max.y - lattice.corner.y, lattice.pitch) + below + 1};
}

Points points_in(const Lattice& lattice, const LegalArea& area) {
  Points points;
  for (int row = 0; row < lattice.rows; ++row) {
    for (int column = 0; column < lattice.columns; ++column) {
      if (area.holds(lattice.at(column, row))) points.push_back(lattice.at(column, row));
    }
  }
  return points;
}

/// What the areas of a layer have in common.
struct Work {
  const Layer& layer;
  const TourGridOptions& options;
  const TourSolver& solve;
  const Tolerances& tol;
  std::vector<Edge> walls;  ///< the passes along the walls
  Cover walls_cover;
  LegalArea target;

  double radius() const { return layer.tool_radius; }
};

/// A way under construction in one legal area: points joined by straight legal moves.
class Route {
 public:
  explicit Route(const LegalWays& ways) : ways_(ways) {}

  const Points& points() const { return points_; }

  /// Visits the points in this order. False where the area does not join two of them: then no more is visited.
  bool follow(const Points& stops) {
    for (const Vec2 stop : stops) {
      if (!points_.empty()) {
        const auto bends = ways_.bends(points_.back(), stop);
        if (!bends) return false;
        points_.insert(points_.end(), bends->begin(), bends->end());
      }
      points_.push_back(stop);
    }
    return true;
  }

  /// Visits p as well, where that costs least: instead of a straight move, or beside it.
  void visit(Vec2 p, bool beside) {
    if (points_.size() < 2) {
      follow({p});
      return;
    }
    std::size_t best = 0;
    Points best_way;
    double best_cost = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const Vec2 a = points_[i], b = points_[i + 1];
      if (extra(a, p, b, beside) >= best_cost) continue;
      const Points way = detour(a, p, b, beside);
      if (way.empty()) continue;
      const double cost = length_through(a, way, b) - distance(a, b);
      if (cost >= best_cost) continue;
      best = i;
      best_cost = cost;
      best_way = way;
    }
    points_.insert(points_.begin() + static_cast<std::ptrdiff_t>(best) + 1, best_way.begin(), best_way.end());
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
  /// What the visit costs at least.
  static double extra(Vec2 a, Vec2 p, Vec2 b, bool beside) {
    if (beside) return a == b ? 2 * distance(a, p) : 2 * distance(Edge::line(a, b), p);
    return distance(a, p) + distance(p, b) - distance(a, b);
  }
  /// What comes between a and b then; empty where there is no way.
  Points detour(Vec2 a, Vec2 p, Vec2 b, bool beside) const {
    const Vec2 foot = a == b ? a : nearest_point(Edge::line(a, b), p);
    const auto there = ways_.bends(beside ? foot : a, p), back = ways_.bends(p, beside ? foot : b);
    if (!there || !back) return {};
    Points way;
    if (beside) way.push_back(foot);
    way.insert(way.end(), there->begin(), there->end());
    way.push_back(p);
    way.insert(way.end(), back->begin(), back->end());
    if (beside) way.push_back(foot);
    return way;
  }
  static double length_through(Vec2 a, const Points& way, Vec2 b) {
    double length = distance(a, way.front()) + distance(way.back(), b);
    for (std::size_t i = 1; i < way.size(); ++i) length += distance(way[i - 1], way[i]);
    return length;
  }

  const LegalWays& ways_;
  Points points_;
};

/// Which points of a lattice are visited: those well inside, and those that clear what no other does.
class GridChoice {
 public:
  GridChoice(const Work& work, const Lattice& lattice, const LegalArea& legal)
      : work_(work),
        lattice_(lattice),
        legal_(legal),
        chosen_(static_cast<std::size_t>(lattice.columns) * static_cast<std::size_t>(lattice.rows), 0) {}

  void choose(const LegalArea& inside) {
    each([&](int column, int row, Vec2 p) {
      if (inside.holds(p) && is_needed(p, [](Vec2) { return true; })) chosen(column, row) = 1;
    });
    each([&](int column, int row, Vec2 p) {
      const auto left_by_others = [&](Vec2 q) { return !is_cleared(q, column, row); };
      if (!chosen(column, row) && legal_.holds(p) && is_needed(p, left_by_others)) chosen(column, row) = 1;
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

  /// Whether a cutter at p clears something of the target that the walls' passes leave and `others` too.
  template <typename Others>
  bool is_needed(Vec2 p, Others&& others) const {
    const auto needs = [&](Vec2 q) {
      return work_.target.contains(q) && !work_.walls_cover.holds(q) && legal_.contains(q) && others(q);
    };
    if (needs(p)) return true;
    for (const double share : kProbes) {
      for (int i = 0; i < kProbeDirections; ++i) {
        if (needs(p + direction_of(2 * kPi * i / kProbeDirections) * (share * work_.radius()))) return true;
      }
    }
    return false;
  }

  /// Whether a chosen point about (column, row) clears q.
  bool is_cleared(Vec2 q, int column, int row) const {
    constexpr int kAround = 3;
    for (int r = std::max(0, row - kAround); r <= std::min(lattice_.rows - 1, row + kAround); ++r) {
      for (int c = std::max(0, column - kAround); c <= std::min(lattice_.columns - 1, column + kAround);
           ++c) {
        if (chosen_[index(c, r)] && distance(lattice_.at(c, r), q) <= work_.radius()) return true;
      }
    }
    return false;
  }

  const Work& work_;
  const Lattice& lattice_;
  const LegalArea& legal_;
  std::vector<char> chosen_;
};

/// Everything about one connected legal area of a layer.
class AreaPlanner {
 public:
  AreaPlanner(const Region& legal, const Work& work)
      : legal_(legal), work_(work), ways_({legal}), route_(ways_) {}

  /// The way through the grid and whatever else must be visited; empty when nothing must.
  Path plan() {
    follow(grid());
    for (int round = 0; !work_.options.published && round < kMendings; ++round) {
      const Points left = holes();
      if (left.empty()) break;
      mend(left, round >= kRerouted);
    }
    return way_through(route_.points());
  }

 private:
  double pitch() const { return work_.options.pitch * (work_.options.pitch_in_mm ? 1 : 2 * work_.radius()); }

  Points grid() const {
    if (work_.options.published) return points_in(published_lattice(legal_.box(), pitch()), ways_.area());
    const Regions inside = inset(legal_, margin(), work_.tol);
    const Box core = inside.empty() ? legal_.box() : box(inside);
    const Lattice lattice = filling(fitted_lattice(core, pitch()), legal_.box());
    GridChoice choice(work_, lattice, ways_.area());
    choice.choose(LegalArea(inside));
    return choice.points();
  }

  /// From the pass along a wall to the first row: then a place between them half a pitch from the nearest
  /// points of the row is just within a radius of those.
  double margin() const {
    const double radius = work_.radius(), half = std::min(pitch() / 2, radius);
    return 0.98 * (radius + std::sqrt(radius * radius - half * half));
  }

  void follow(const Points& points) {
    if (points.empty()) return;
    TourTask task;
    task.points = points;
    task.pitch = pitch();
    task.layer = &work_.layer;
    const LegalWays::Between between(ways_, points);
    if (!ways_.all_straight())
      task.way = [&](int a, int b) { return between.bends(a, b).value_or(Points{}); };
    Points stops;
    for (const int i : points.size() > 1 ? work_.solve(task) : std::vector<int>{0})
      stops.push_back(points[i]);
    CLEARCUT_ASSERT(stops.size() == points.size());
    route_.follow(stops);
  }

  /// Places of the target that neither the walls' passes nor the way clear.
  Points holes() const {
    std::vector<Edge> edges = work_.walls;
    for (const auto& edge : way_through(route_.points())) {
      if (edge.from != edge.to) edges.push_back(edge);
    }
    if (edges.empty()) return {};
    const Cover cover(edges, work_.radius());
    const auto matters = [&](Vec2 p) { return ways_.area().contains(p) && work_.target.contains(p); };
    Points found = cover.holes(matters);
    for (const auto& region : work_.layer.target) {
      for (const auto& edge : region.edges()) add_rim(edge, cover, found);
    }
    return found;
  }

  /// A hole may be bounded by the target's own edge alone.
  void add_rim(const Edge& edge, const Cover& cover, Points& found) const {
    const int count = 1 + static_cast<int>(4 * edge.length() / work_.radius());
    for (int i = 0; i < count; ++i) {
      const Vec2 p = edge.at((i + 0.5) / count);
      if (ways_.area().contains(p) && !cover.holds(p, -work_.tol.uncut / 2)) found.push_back(p);
    }
  }

  /// Visits every hole; one visit serves all that it reaches. Beside the way as far in as its rim, so that no
  /// long thin hole is nibbled at.
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

  /// A few of the points, such that every other is within half a radius of one.
  Points thinned(const Points& points) const {
    Points kept;
    for (const Vec2 p : points) {
      const bool near =
          std::any_of(kept.begin(), kept.end(), [&](Vec2 q) { return distance(p, q) < work_.radius() / 2; });
      if (!near) kept.push_back(p);
    }
    return kept;
  }

  /// From where the first hole and those around it are cleared: as near to the way as possible. Where no place
  /// serves all of them the hole is large and visited at its rim.
  Vec2 place_for(const Points& left) const {
    const double radius = work_.radius();
    Points group;
    Vec2 middle{};
    for (const Vec2 p : left) {
      if (distance(p, left.front()) < 2 * radius) group.push_back(p), middle = middle + p;
    }
    middle = middle / static_cast<double>(group.size());
    const auto serves = [&](Vec2 place) {
      return ways_.area().holds(place) && std::all_of(group.begin(), group.end(), [&](Vec2 p) {
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
  const Work& work_;
  LegalWays ways_;
  Route route_;
};

/// The rings along the walls and the lines on which the cutter just fits.
LayerPasses wall_passes(const Layer& layer, const Tolerances& tol) {
  ContourOptions rings;
  rings.residuals = ResidualRule::kNone;
  LayerPasses result = plan_contour(layer, rings, tol);
  std::erase_if(result.passes, [](const Pass& pass) { return pass.parent >= 0; });
  return result;
}

/// The ring at the wall of a legal area: what the way through the grid is surrounded by; -1 none.
int ring_around(const Region& legal, const LayerPasses& walls) {
  for (std::size_t i = 0; i < walls.passes.size(); ++i) {
    const Pass& pass = walls.passes[i];
    if (!pass.closed) continue;
    const Vec2 p = pass.path.front().from;
    if (legal.contains(p) || legal.boundary_distance(p) < 1e-3) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace

TourGridOptions parse_tour_grid(const std::string& text) {
  const StepRule rule = parse_step_rule(text);
  TourGridOptions options;
  if (rule.kind == StepRule::Kind::kFraction) {
    options.pitch = rule.value;
  } else if (rule.kind == StepRule::Kind::kMm) {
    options.pitch = rule.value;
    options.pitch_in_mm = true;
  } else if (rule.kind != StepRule::Kind::kWidest) {
    throw InputError("--stepover", fmt::format("'{}' has no meaning for a grid; use 0.7 or 3.5mm", text));
  }
  return options;
}

LayerPasses plan_tour(const Layer& layer, const TourGridOptions& options, const TourSolver& solve,
                      const Tolerances& tol) {
  LayerPasses result = wall_passes(layer, tol);
  result.strategy = "tour";
  std::vector<Edge> walls;
  int components = 0;
  for (const auto& pass : result.passes) {
    std::copy_if(pass.path.begin(), pass.path.end(), std::back_inserter(walls),
                 [](const Edge& edge) { return edge.from != edge.to; });
    components = std::max(components, pass.component + 1);
  }
  const Work work{
      layer, options, solve, tol, walls, Cover(walls, layer.tool_radius), LegalArea(layer.target)};
  std::vector<Pass> tours;
  for (const auto& legal : result.legal) {
    Pass pass;
    pass.path = AreaPlanner(legal, work).plan();
    if (pass.path.empty()) continue;
    pass.parent = options.published ? -1 : ring_around(legal, result);
    pass.component =
        pass.parent < 0 ? components++ : result.passes[static_cast<std::size_t>(pass.parent)].component;
    tours.push_back(std::move(pass));
  }
  if (options.published) result.passes.clear();
  result.passes.insert(result.passes.end(), tours.begin(), tours.end());
  return result;
}

}  // namespace clearcut
