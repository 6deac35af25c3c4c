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

// Tours of files, lattices and points, and their texts; include/clearcut/order.h promises these functions and says more of them.
TourResult solve_tour(const std::string& input, const TourOptions& options);
TourResult solve_tour(const order::Problem& problem, const TourOptions& options);

std::string tour_json(const TourResult& result);
std::string tour_svg(const TourResult& result);
std::string tour_line(const TourResult& result);

/// Throws InputError for an unknown objective.
order::ObjectivePtr objective_named(const std::string& text, double feed);

}  // namespace clearcut::pipeline
