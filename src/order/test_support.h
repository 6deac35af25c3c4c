// What the tests of ordering share: reference instances and random problems.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include "base/random.h"
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
