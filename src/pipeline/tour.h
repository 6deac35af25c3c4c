// Tours over point sets from files and lattices.
#pragma once

#include <optional>
#include <string>

#include "order/genetic/genetic.h"
#include "order/solve.h"

namespace clearcut {

struct TourOptions {
  std::string objective = "length";  ///< length, turns, angle, time, or weights "0.5:length,20:turns"
  std::optional<bool> closed;        ///< default: TSPLIB files closed, lattices open
  double time_s = 10;
  std::uint64_t seed = 1;
  int threads = 0;                        ///< 0: all cores
  double feed = 1000;                     ///< mm/min, for the objective time
  std::string solver = "modern";          ///< or "published": the text's genetic algorithm
  order::GeneticOptions genetic;          ///< of the published solver; seed and time come from here above
  std::optional<int> genetic_neighbours;  ///< default as the text: lattices 24, files all points (5.3.2)
};

struct TourResult {
  order::Problem problem;
  order::Solution solution;
  std::string objective;
};

/// `input` is a TSPLIB file or a lattice such as "10x10". Throws InputError.
TourResult solve_tour(const std::string& input, const TourOptions& options);

/// The fields of `tour --json`: objective, length, turns, angle_deg, bound, gap, time_s, seed, tour
/// (0-based).
std::string tour_json(const TourResult& result);
std::string tour_svg(const TourResult& result);
std::string tour_line(const TourResult& result);

/// Throws InputError for an unknown objective.
order::ObjectivePtr objective_named(const std::string& text, double feed);

}  // namespace clearcut
