// Tours over point sets: options and results.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "order/genetic/genetic.h"
#include "order/search/solve.h"

namespace clearcut::order {

/// A value better than all earlier ones.
struct TourSample {
  double seconds = 0;  ///< since the search began
  double best = 0;     ///< best value of the objective
};

struct TourOptions {
  /// length, turns, angle, time, engagement, engagement-inverse, engagement-exact, or weights "0.5:length,20:turns"
  std::string objective = "length";
  std::optional<bool> closed;  ///< default: TSPLIB files closed, lattices open
  double time_s = 10;
  std::uint64_t seed = 1;
  int threads = 0;     ///< 0: all cores
  double feed = 1000;  ///< mm/min, for the objective time
  /// mm; diameter of the cutter for engagement; default: two pitches of the points.
  std::optional<double> diameter;
  double engagement_percent = 50;  ///< wanted share of the leading half circle in material
  std::string solver = "modern";   ///< or "published": the text's genetic algorithm
  /// Options of the published solver; seed and time are taken from the members above.
  GeneticOptions genetic;
  std::optional<int> genetic_neighbours;  ///< 0: all points; default 24
  std::stop_token cancel;  ///< asked to stop, the search ends with Cancelled within some milliseconds
  /// Called for each better value, by one thread at a time; may be empty.
  std::function<void(const TourSample&)> improved;
};

struct TourResult {
  Problem problem;
  Solution solution;
  std::string objective;
  /// Decrease of the best value, from the first to the last; of more than a thousand values every other one is left
  /// out.
  std::vector<TourSample> convergence = {};
};

}  // namespace clearcut::order
