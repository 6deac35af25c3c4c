// Functions of include/clearcut/order.h, by calls of the stages.
#include <clearcut/order.h>

#include <utility>

#include "pipeline/tour/tour.h"

namespace clearcut {

TourResult solve_tour(const std::string& input, const TourOptions& options) {
  return pipeline::solve_tour(input, options);
}

TourResult solve_tour(const order::Problem& problem, const TourOptions& options) {
  return pipeline::solve_tour(problem, options);
}

std::string tour_json(const TourResult& result) {
  return pipeline::tour_json(result);
}

std::string tour_line(const TourResult& result) {
  return pipeline::tour_line(result);
}

std::string tour_svg(const TourResult& result) {
  return pipeline::tour_svg(result);
}

order::Solution solve_order(const order::Problem& problem, const order::Objective& objective,
                            const order::SolveOptions& options) {
  return order::solve(problem, objective, options);
}

}  // namespace clearcut
