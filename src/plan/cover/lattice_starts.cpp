#include "plan/cover/lattice_starts.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>

#include "base/progress.h"
#include "base/units.h"
#include "geometry/route/legal_area.h"
#include "order/search/solve.h"

namespace clearcut::plan::cover {
namespace {

/// Samples along the side of a lattice's square.
constexpr int kSamples = 8;
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
    const double pitch = 2 * options.radius / kSamples;
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
        const double held = count / static_cast<double>(kSamples * kSamples);
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
      if (count >= choice.share * kSamples * kSamples) points.push_back(p);
    }
    if (points.empty()) points = all;
    if (points.empty()) points.push_back(samples_[samples_.size() / 2]);
    return points;
  }

 private:
  const LatticeStartOptions& options_;
  std::vector<Vec2> samples_;
};

std::vector<Vec2> ordered(const std::vector<Vec2>& points, const LatticeStartOptions& options) {
  if (points.size() < 3) return points;
  order::Problem problem;
  problem.name = "lattice";
  problem.points = points;
  problem.shape = options.closed ? order::Shape::kClosedTour : order::Shape::kOpenPath;
  if (options.bends)
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
  return path;
}

}  // namespace

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
