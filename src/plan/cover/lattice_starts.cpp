#include "plan/cover/lattice_starts.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>

#include "base/progress.h"
#include "base/units.h"
#include "geometry/box.h"
#include "geometry/route/legal_area.h"
#include "order/search/solve.h"

namespace clearcut::plan::cover {
namespace {

/// Samples along the side of a lattice's square; fewer in areas that would have more samples than the number below.
constexpr double kSamples = 8, kMostSamples = 60'000;
/// A place is visited when its square holds at least this share of the area.
constexpr double kShares[] = {0.15, 0.4};
/// Cost of uncovered area: mm of path for each square diameter outside of all squares, over the pitch.
constexpr double kLeftCost = 1.6;
/// Number of tried directions of walls, and of phases along each axis.
constexpr std::size_t kMostDirections = 5;
constexpr std::size_t kMostPhases = 4;
/// Cost of a turn of the first path, in radii: the corner outside of the turn is left.
constexpr double kTurnPrice = 0.25;
constexpr double kNear = 0.5 * kPi / 180;  ///< radians; directions nearer than this are one

std::vector<Edge> straight_edges(const Regions& area) {
  std::vector<Edge> edges;
  for (const Edge& edge : edges_of(area))
    if (!edge.is_arc()) edges.push_back(edge);
  return edges;
}

/// Directions modulo a right angle, those of the longest walls first.
std::vector<double> wall_directions(const std::vector<Edge>& edges) {
  std::vector<std::pair<double, double>> found;  // length, direction
  for (const Edge& edge : edges) {
    double direction = std::fmod(angle_of(edge.to - edge.from) + 2 * kPi, kPi / 2);
    if (direction > kPi / 2 - kNear) direction = 0;
    const auto same = std::find_if(found.begin(), found.end(), [&](const auto& other) {
      return std::abs(other.second - direction) < kNear;
    });
    if (same != found.end())
      same->first += edge.length();
    else
      found.push_back({edge.length(), direction});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<double> directions;
  for (const auto& [length, direction] : found)
    if (directions.size() < kMostDirections) directions.push_back(direction);
  if (directions.empty()) directions.push_back(0);
  return directions;
}

/// Phases of lattice lines, mm below the pitch, of lines running one radius beside the longest walls across the axis;
/// then even ones.
std::vector<double> phases(const std::vector<Edge>& edges, double direction, bool along_x, double radius) {
  const double pitch = 2 * radius;
  std::vector<std::pair<double, double>> found;
  for (const Edge& edge : edges) {
    const Vec2 a = rotated(edge.from, -direction), b = rotated(edge.to, -direction);
    const Vec2 way = b - a;
    if (std::abs(along_x ? way.x : way.y) > kNear * norm(way)) continue;
    // Material is on the left.
    const double inside = along_x ? (way.y > 0 ? -1 : 1) : (way.x > 0 ? 1 : -1);
    double phase = std::fmod((along_x ? a.x : a.y) + inside * radius, pitch);
    if (phase < 0) phase += pitch;
    const auto same = std::find_if(found.begin(), found.end(), [&](const auto& other) {
      return std::abs(std::remainder(other.second - phase, pitch)) < 0.02 * radius;
    });
    if (same != found.end())
      same->first += edge.length();
    else
      found.push_back({edge.length(), phase});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<double> result;
  for (const auto& [length, phase] : found)
    if (result.size() < kMostPhases) result.push_back(phase);
  for (double share = 0; share < 1 && result.size() < kMostPhases; share += 0.25)
    result.push_back(share * pitch);
  return result;
}

struct Choice {
  double direction = 0;
  Vec2 phase;
  double share = 0;
  double cost = 0;
};

class Lattices {
 public:
  Lattices(const Regions& area, const LatticeStartOptions& options) : options_(options) {
    const Box box = geometry::box(area);
    const LegalArea inside(area);
    const double pitch =
        std::max(2 * options.radius / kSamples, std::sqrt(geometry::area(area) / kMostSamples));
    of_square_ = 4 * options.radius * options.radius / (pitch * pitch);
    for (double y = box.min.y + pitch / 2; y < box.max.y; y += pitch)
      for (double x = box.min.x + pitch / 2; x < box.max.x; x += pitch)
        if (inside.contains({x, y})) samples_.push_back({x, y});
    if (samples_.empty()) samples_.push_back(box.center());
  }

  using Squares = std::map<std::pair<long, long>, int>;
  Squares squares(double direction, Vec2 phase) const {
    Squares squares;
    const double c = base::cos(-direction), s = base::sin(-direction), pitch = 2 * options_.radius;
    std::pair<long, long> last{};
    int* count = nullptr;
    for (const Vec2 p : samples_) {
      const Vec2 q{c * p.x - s * p.y, s * p.x + c * p.y};
      const std::pair<long, long> at{std::lround((q.x - phase.x) / pitch),
                                     std::lround((q.y - phase.y) / pitch)};
      if (count == nullptr || at != last) {
        count = &squares[at];
        last = at;
      }
      ++*count;
    }
    return squares;
  }

  void rate(Choice choice, std::vector<Choice>& rated) const {
    const auto counts = squares(choice.direction, choice.phase);
    for (const double share : kShares) {
      choice.share = share;
      choice.cost = 0;
      for (const auto& [at, count] : counts) {
        const double held = count / of_square_;
        choice.cost += held >= share ? 1 : kLeftCost * held;
      }
      rated.push_back(choice);
    }
  }

  std::vector<Vec2> points(const Choice& choice) const {
    std::vector<Vec2> points, all;
    for (const auto& [at, count] : squares(choice.direction, choice.phase)) {
      const Vec2 p =
          rotated(choice.phase + 2 * options_.radius *
                                     Vec2{static_cast<double>(at.first), static_cast<double>(at.second)},
                  choice.direction);
      if (options_.may_stand && !options_.may_stand(p)) continue;
      all.push_back(p);
      if (count >= choice.share * of_square_) points.push_back(p);
    }
    if (points.empty()) points = all;
    if (points.empty()) points.push_back(samples_[samples_.size() / 2]);
    return points;
  }

 private:
  const LatticeStartOptions& options_;
  std::vector<Vec2> samples_;
  double of_square_ = 1;  ///< samples of a whole square
};

/// Whether the center may be at all points; with the bends of moves that would be illegal.
bool make_legal(std::vector<Vec2>& path, const LatticeStartOptions& options) {
  if (options.may_stand && !std::all_of(path.begin(), path.end(), options.may_stand)) return false;
  if (!options.bends) return true;
  std::vector<Vec2> legal;
  for (const Vec2 p : path) {
    if (!legal.empty()) {
      const std::vector<Vec2> bends = options.bends(legal.back(), p);
      legal.insert(legal.end(), bends.begin(), bends.end());
    }
    legal.push_back(p);
  }
  if (options.closed && !legal.empty()) {
    const std::vector<Vec2> bends = options.bends(legal.back(), legal.front());
    legal.insert(legal.end(), bends.begin(), bends.end());
  }
  path = std::move(legal);
  return true;
}

std::vector<Vec2> ordered(const std::vector<Vec2>& points, const LatticeStartOptions& options) {
  if (points.size() < 3) return points;
  order::Problem problem;
  problem.name = "lattice";
  problem.points = points;
  problem.shape = options.closed ? order::Shape::kClosedTour : order::Shape::kOpenPath;
  if (options.bends && options.orders_by_detours)
    problem.detour = [&](int from, int to) {
      return options.bends(points[static_cast<std::size_t>(from)], points[static_cast<std::size_t>(to)]);
    };
  order::SolveOptions solve;
  solve.seed = options.seed;
  solve.threads = 1;
  solve.stop.effort = options.effort;
  solve.stop.seconds = std::numeric_limits<double>::infinity();
  solve.stop.rounds = 2;
  const auto objective = order::weighted_sum(
      {{1.0, order::length_objective()}, {kTurnPrice * options.radius, order::turns_objective()}});
  std::atomic<bool> stop = false;
  const std::stop_callback on_cancel(options.cancel, [&stop] { stop = true; });
  solve.stop.cancel = &stop;
  const order::Tour tour = order::solve(problem, *objective, solve).tour;
  throw_if_cancelled(options.cancel);
  std::vector<Vec2> path;
  order::each_edge(problem, tour, [&](int a, int b) {
    const std::vector<Vec2> way = order::move_points(problem, a, b);
    path.insert(path.end(), way.begin(), way.end() - 1);
  });
  if (!problem.closed()) path.push_back(points[static_cast<std::size_t>(tour.back())]);
  if (!problem.detour) make_legal(path, options);
  return path;
}

/// Lines across each strip at which its extent is searched.
constexpr int kLinesOfStrip = 9;
/// Curves count as chords no farther from them than this share of the radius.
constexpr double kStripChord = 1e-3;
/// Share of a strip by which its width may exceed the disc's diameter by rounding.
constexpr double kStripRounding = 1e-9;

/// Stretches of the line y = `at` within polygons, joined where they touch.
std::vector<std::pair<double, double>> stretches_at(const std::vector<std::vector<Vec2>>& polygons,
                                                    double at) {
  std::vector<double> crossings;
  for (const auto& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if ((a.y > at) != (b.y > at)) crossings.push_back(a.x + (b.x - a.x) * (at - a.y) / (b.y - a.y));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  std::vector<std::pair<double, double>> stretches;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    stretches.emplace_back(crossings[i], crossings[i + 1]);
  return stretches;
}

/// Joins stretches that overlap or are no farther than `gap` apart.
std::vector<std::pair<double, double>> joined(std::vector<std::pair<double, double>> stretches, double gap) {
  std::sort(stretches.begin(), stretches.end());
  std::vector<std::pair<double, double>> result;
  for (const auto& [first, last] : stretches) {
    if (!result.empty() && first <= result.back().second + gap)
      result.back().second = std::max(result.back().second, last);
    else
      result.emplace_back(first, last);
  }
  return result;
}

/// Middle lines of the strips in direction `direction`, from below.
std::vector<std::pair<Vec2, Vec2>> strips(const Regions& area, double direction, double radius) {
  std::vector<std::vector<Vec2>> polygons;
  Box box;
  const auto add = [&](const Loop& loop) {
    std::vector<Vec2> polygon = flattened(loop, kStripChord * radius);
    for (Vec2& p : polygon) {
      p = rotated(p, -direction);
      box.add(p);
    }
    polygons.push_back(std::move(polygon));
  };
  for (const Region& region : area) {
    add(region.outer());
    for (const Loop& island : region.islands()) add(island);
  }
  const int count = std::max(1, static_cast<int>(std::ceil(box.height() / (2 * radius) - kStripRounding)));
  const double width = box.height() / count;
  std::vector<std::pair<Vec2, Vec2>> lines;
  for (int i = 0; i < count; ++i) {
    std::vector<std::pair<double, double>> stretches;
    for (int k = 0; k < kLinesOfStrip; ++k) {
      const auto more = stretches_at(polygons, box.min.y + (i + (k + 0.5) / kLinesOfStrip) * width);
      stretches.insert(stretches.end(), more.begin(), more.end());
    }
    const double middle = box.min.y + (i + 0.5) * width;
    for (const auto& [first, last] : joined(std::move(stretches), 2 * radius))
      lines.emplace_back(rotated({first, middle}, direction), rotated({last, middle}, direction));
  }
  return lines;
}

/// Path along all lines: from the first, always on to the nearest end.
std::vector<Vec2> along_lines(std::vector<std::pair<Vec2, Vec2>> lines) {
  std::vector<Vec2> path;
  while (!lines.empty()) {
    std::size_t next = 0;
    bool turned = false;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; !path.empty() && i < lines.size(); ++i) {
      for (const bool from_end : {false, true}) {
        const double away = distance(path.back(), from_end ? lines[i].second : lines[i].first);
        if (away < nearest) {
          nearest = away;
          next = i;
          turned = from_end;
        }
      }
    }
    path.push_back(turned ? lines[next].second : lines[next].first);
    path.push_back(turned ? lines[next].first : lines[next].second);
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(next));
  }
  return path;
}

}  // namespace

std::vector<std::vector<Vec2>> strip_starts(const Regions& area, const LatticeStartOptions& options) {
  std::vector<std::pair<double, std::vector<Vec2>>> rated;
  for (const double direction : wall_directions(straight_edges(area))) {
    for (const double turn : {0.0, kPi / 2}) {
      std::vector<Vec2> path = along_lines(strips(area, direction + turn, options.radius));
      if (path.empty() || !make_legal(path, options)) continue;
      double cost = kTurnPrice * options.radius * static_cast<double>(path.size());
      for (std::size_t i = 1; i < path.size(); ++i) cost += distance(path[i - 1], path[i]);
      rated.emplace_back(cost, std::move(path));
    }
  }
  std::stable_sort(rated.begin(), rated.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::vector<Vec2>> paths;
  for (auto& [cost, path] : rated)
    if (paths.size() < std::min<std::size_t>(2, options.most)) paths.push_back(std::move(path));
  return paths;
}

std::vector<std::vector<Vec2>> lattice_starts(const Regions& area, const LatticeStartOptions& options) {
  const Lattices lattices(area, options);
  const std::vector<Edge> edges = straight_edges(area);
  std::vector<Choice> rated;
  for (const double direction : wall_directions(edges))
    for (const double x : phases(edges, direction, true, options.radius))
      for (const double y : phases(edges, direction, false, options.radius))
        lattices.rate({direction, {x, y}, 0, 0}, rated);
  std::stable_sort(rated.begin(), rated.end(),
                   [](const Choice& a, const Choice& b) { return a.cost < b.cost; });
  std::vector<std::vector<Vec2>> paths, tried;
  for (std::size_t i = 0; i < rated.size() && paths.size() < options.most; ++i) {
    std::vector<Vec2> points = lattices.points(rated[i]);
    if (std::find(tried.begin(), tried.end(), points) != tried.end()) continue;
    paths.push_back(ordered(points, options));
    tried.push_back(std::move(points));
  }
  return paths;
}

}  // namespace clearcut::plan::cover
