#include "order/problem.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

#include "base/error.h"

namespace clearcut::order {

namespace {

// Sums of rounded distances stay exact integers below this.
constexpr double kLargestCoordinate = 1e12;

double in_metric(Metric metric, double length) {
  return metric == Metric::kRoundedEuc2d ? std::floor(length + 0.5) : length;
}

double plain_distance(Vec2 a, Vec2 b) {
  const Vec2 d = a - b;
  return std::sqrt(d.x * d.x + d.y * d.y);
}

void check_points(const Problem& problem) {
  if (problem.points.empty()) throw InputError(problem.name, "no points; give at least one");
  for (int i = 0; i < problem.size(); ++i) {
    const Vec2 p = problem.points[i];
    if (!(std::abs(p.x) <= kLargestCoordinate && std::abs(p.y) <= kLargestCoordinate)) {
      throw InputError(problem.name,
                       "point " + std::to_string(i + 1) + " is not a number within 1e12; correct it");
    }
  }
}

void check_index(const Problem& problem, int index, const char* what) {
  if (index < 0 || index >= problem.size()) {
    throw InputError(problem.name, std::string(what) + " " + std::to_string(index) +
                                       " is not a point; use 0 to " + std::to_string(problem.size() - 1));
  }
}

void check_ends(const Problem& problem) {
  const bool fixed = problem.start != -1 || problem.end != -1;
  if (problem.closed() && (fixed || !problem.precedence.empty())) {
    throw InputError(problem.name, "a closed tour has no ends and no precedence; use an open path");
  }
  if (problem.start != -1) check_index(problem, problem.start, "start");
  if (problem.end != -1) check_index(problem, problem.end, "end");
  if (problem.start != -1 && problem.start == problem.end && problem.size() > 1) {
    throw InputError(problem.name, "start and end of the path are the same point; use a closed tour");
  }
}

void check_precedence(const Problem& problem) {
  for (const Precedence& p : problem.precedence) {
    check_index(problem, p.before, "precedence of point");
    check_index(problem, p.after, "precedence of point");
    if (p.before == p.after || p.after == problem.start || p.before == problem.end) {
      throw InputError(problem.name, "precedence " + std::to_string(p.before) + " before " +
                                         std::to_string(p.after) + " cannot be kept; remove it");
    }
  }
  topological_order(problem);
}

}  // namespace

void check(const Problem& problem) {
  check_points(problem);
  check_ends(problem);
  check_precedence(problem);
}

double straight_distance(const Problem& problem, int a, int b) {
  return in_metric(problem.metric, plain_distance(problem.points[a], problem.points[b]));
}

double way_length(const Problem& problem, std::span<const Vec2> points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += plain_distance(points[i - 1], points[i]);
  return in_metric(problem.metric, length);
}

std::vector<Vec2> move_points(const Problem& problem, int a, int b) {
  std::vector<Vec2> points{problem.points[a]};
  if (problem.detour) {
    const std::vector<Vec2> between = problem.detour(a, b);
    points.insert(points.end(), between.begin(), between.end());
  }
  points.push_back(problem.points[b]);
  return points;
}

double move_length(const Problem& problem, int a, int b) {
  if (!problem.detour) return straight_distance(problem, a, b);
  return way_length(problem, move_points(problem, a, b));
}

double tour_length(const Problem& problem, std::span<const int> tour) {
  double length = 0;
  for (std::size_t i = 1; i < tour.size(); ++i) length += move_length(problem, tour[i - 1], tour[i]);
  if (problem.closed() && tour.size() > 1) length += move_length(problem, tour.back(), tour.front());
  return length;
}

bool is_valid(const Problem& problem, std::span<const int> tour) {
  if (static_cast<int>(tour.size()) != problem.size()) return false;
  std::vector<int> place(problem.points.size(), -1);
  for (std::size_t i = 0; i < tour.size(); ++i) {
    if (tour[i] < 0 || tour[i] >= problem.size() || place[tour[i]] != -1) return false;
    place[tour[i]] = static_cast<int>(i);
  }
  if (problem.start != -1 && tour.front() != problem.start) return false;
  if (problem.end != -1 && tour.back() != problem.end) return false;
  return std::all_of(problem.precedence.begin(), problem.precedence.end(),
                     [&](const Precedence& p) { return place[p.before] < place[p.after]; });
}

Tour topological_order(const Problem& problem) {
  const int n = problem.size();
  std::vector<std::vector<int>> after(n);
  std::vector<int> waiting(n, 0);
  for (const Precedence& p : problem.precedence) {
    after[p.before].push_back(p.after);
    ++waiting[p.after];
  }
  // Smallest (rank, index) first, with separate ranks for the fixed ends.
  const auto rank = [&](int v) { return v == problem.start ? 0 : v == problem.end ? 2 : 1; };
  using Entry = std::pair<int, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> ready;
  for (int v = 0; v < n; ++v) {
    if (waiting[v] == 0) ready.push({rank(v), v});
  }
  Tour tour;
  while (!ready.empty()) {
    const int v = ready.top().second;
    ready.pop();
    tour.push_back(v);
    for (const int w : after[v]) {
      if (--waiting[w] == 0) ready.push({rank(w), w});
    }
  }
  if (static_cast<int>(tour.size()) != n) {
    throw InputError(problem.name, "precedence runs in a circle; remove one of its relations");
  }
  return tour;
}

Tour canonical(const Problem& problem, Tour tour) {
  if (tour.size() < 2) return tour;
  if (problem.closed()) {
    std::rotate(tour.begin(), std::min_element(tour.begin(), tour.end()), tour.end());
    if (tour.size() > 2 && tour.back() < tour[1]) std::reverse(tour.begin() + 1, tour.end());
  } else if (problem.start == -1 && problem.end == -1 && problem.precedence.empty()) {
    if (tour.back() < tour.front()) std::reverse(tour.begin(), tour.end());
  }
  return tour;
}

}  // namespace clearcut::order
