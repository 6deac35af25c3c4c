// Tours over points under any cost: solve_tour() for files and lattices by name, solve_order() for problems of one's own.
#pragma once

#include <string>

#include "order/genetic/operators.h"
#include "order/genetic/tours.h"
#include "order/search/solve.h"

namespace clearcut {

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
std::string tour_line(const TourResult& result);
std::string tour_svg(const TourResult& result);

/// Orders the points of a problem, with a proven bound; see order::solve. Throws InputError for problems that contradict
/// themselves.
order::Solution solve_order(const order::Problem& problem, const order::Objective& objective,
                            const order::SolveOptions& options);

}  // namespace clearcut
