// What the tests of ordering share: instances with known optima, reference instances where they are, random problems.
// For tests: small problems of every kind.
#pragma once

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "base/elementary.h"
#include "base/random.h"
#include "base/units.h"
#include "order/problem.h"
#include "order/tsplib.h"

namespace clearcut::order {

/// The text of a file in the data folder's tsp directory; absent when there is no such folder.
inline std::optional<std::string> reference_text(const std::string& file) {
  const char* root = std::getenv("CLEARCUT_DATA");
  const std::filesystem::path data = root ? root : CLEARCUT_SOURCE_DIR "/../shared/data";
  std::ifstream stream(data / "tsp" / file);
  if (!stream) return std::nullopt;
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// An instance whose optimal tour is known, in TSPLIB text form.
struct KnownInstance {
  std::string name;
  std::string text;
  Tour tour;  ///< optimal
};

inline KnownInstance known_instance(const std::string& name, const std::vector<Vec2>& points, Tour tour) {
  std::string text = "NAME : " + name + "\nTYPE : TSP\nDIMENSION : " + std::to_string(points.size()) +
                     "\nEDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n";
  for (std::size_t i = 0; i < points.size(); ++i)
    text +=
        std::to_string(i + 1) + " " + std::to_string(points[i].x) + " " + std::to_string(points[i].y) + "\n";
  return {name, text + "EOF\n", std::move(tour)};
}

/// `n` points on the curve r = 10000 (1 + wave cos 5 t), mixed. A circle's tour is the convex hull; a curve that is
/// sampled much more closely than it bends has itself as its shortest tour.
inline KnownInstance known_curve(const std::string& name, int n, double wave) {
  Random random(7);
  Tour tour(static_cast<std::size_t>(n));
  std::vector<Vec2> points(tour.size());
  std::vector<int> place(tour.size());
  for (int i = 0; i < n; ++i) place[static_cast<std::size_t>(i)] = i;
  for (int i = n; i > 1; --i)
    std::swap(place[static_cast<std::size_t>(i - 1)], place[random.below(static_cast<std::uint64_t>(i))]);
  for (std::size_t i = 0; i < tour.size(); ++i) {
    const double t = 2 * kPi * static_cast<double>(i) / n;
    points[static_cast<std::size_t>(place[i])] = direction_of(t) * 10000 * (1 + wave * base::cos(5 * t));
    tour[i] = place[i];
  }
  return known_instance(name, points, tour);
}

/// columns x rows points, columns even, 10 mm apart: along the first row and back through the columns, up one and
/// down the next. No edge is longer than the pitch, so no tour is shorter.
inline KnownInstance known_lattice(int columns, int rows) {
  std::vector<Vec2> points;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) points.push_back({10.0 * x, 10.0 * y});
  Tour tour;
  for (int x = 0; x < columns; ++x) tour.push_back(x);
  for (int x = columns - 1; x >= 0; --x)
    for (int k = 1; k < rows; ++k) tour.push_back((x % 2 == 1 ? k : rows - k) * columns + x);
  return known_instance("lattice", points, tour);
}

inline std::vector<KnownInstance> known_instances() {
  return {known_curve("circle52", 52, 0), known_curve("flower280", 280, 0.3), known_lattice(14, 14)};
}

inline Problem random_problem(int n, std::uint64_t seed) {
  Random random(seed);
  Problem problem;
  problem.name = "random";
  for (int i = 0; i < n; ++i) problem.points.push_back({random.between(0, 100), random.between(0, 100)});
  return problem;
}

inline Tour random_tour_of(int n, Random& random) {
  Tour tour(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) tour[i] = i;
  for (int i = n; i > 1; --i) std::swap(tour[i - 1], tour[random.below(static_cast<std::uint64_t>(i))]);
  return tour;
}

}  // namespace clearcut::order

namespace clearcut::order::testing {

/// Small problems of every kind: closed, open, fixed ends, precedence, duplicates, rounding.
inline Problem small_problem(int kind, int n, std::uint64_t seed) {
  Problem problem = random_problem(n, seed);
  if (seed % 2 == 0) {
    for (Vec2& p : problem.points) p = {std::round(p.x / 25), std::round(p.y / 25)};
  }
  if (seed % 3 == 0) problem.metric = Metric::kRoundedEuc2d;
  if (kind == 0) return problem;
  problem.shape = Shape::kOpenPath;
  if (kind == 2 && n > 1) problem.start = 1;
  if (kind == 3 && n > 1) problem.start = 0, problem.end = n - 1;
  if (kind == 4 && n > 3) problem.precedence = {{3, 0}, {2, 1}, {0, 1}};
  return problem;
}

}  // namespace clearcut::order::testing
