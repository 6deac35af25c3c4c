// Tours over point sets from files and lattices.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "order/genetic/genetic.h"
#include "order/genetic/tours.h"
#include "order/search/solve.h"

namespace clearcut::pipeline {

using order::TourOptions;
using order::TourResult;
using order::TourSample;

/// `input` is a TSPLIB file or a lattice, for example "10x10". Throws InputError.
TourResult solve_tour(const std::string& input, const TourOptions& options);
/// The same for given points; options.closed is ignored. Throws InputError for contradictory problems.
TourResult solve_tour(const order::Problem& problem, const TourOptions& options);

/// The fields of `tour --json`: objective, length, turns, angle_deg, bound, gap, time_s, seed, convergence (pairs of
/// seconds and best value), tour (0-based).
std::string tour_json(const TourResult& result);
std::string tour_svg(const TourResult& result);
std::string tour_line(const TourResult& result);

/// Throws InputError for an unknown objective.
order::ObjectivePtr objective_named(const std::string& text, double feed);

}  // namespace clearcut::pipeline
