// The optimiser behind the strategy "tour": objectives by name, for grids of a layer.
#pragma once

#include <functional>

#include "model/options/resolved_plan.h"
#include "order/genetic/genetic.h"
#include "order/objective.h"
#include "order/problem.h"
#include "plan/tour/tour.h"

namespace clearcut::pipeline {

/// Makes the objective of one quantity.
using ObjectiveMaker = std::function<order::ObjectivePtr(ObjectiveKind kind)>;

/// The quantity itself, or the weighted sum.
order::ObjectivePtr objective_of(const Objective& objective, const ObjectiveMaker& make);

/// Seconds on a machine that accelerates: length / feed, and at every corner the loss from slowing down to the speed
/// of the junction (Grbl's rule, see kinematic_time) and accelerating again. As exact as kinematic_time for moves
/// long enough to reach the feed; an exchange is evaluated from the few moves it changes.
order::ObjectivePtr machine_time_objective(const Machine& machine, MmPerMin feed);

/// An open path through the points of a grid, along legal paths.
order::Problem grid_problem(const plan::tour::TourTask& task);

/// Settings of the text's genetic algorithm.
struct PublishedOrder {
  PublishedSolver solver;
  std::uint64_t seed = 1;
  std::optional<double> seconds;  ///< upper limit; absent: the solver's default
  std::stop_token cancel;
};

/// The text's genetic algorithm on any problem. Few points are ordered exactly, without samples.
order::GeneticResult published_order(const order::Problem& problem, const order::Objective& objective,
                                     const PublishedOrder& how);

/// Orders grids by `order`, an objective without load. Without plan.search_s the same points give the same order, at any load of the
/// machine. `briefly`: with a fifth of the usual search, which seldom affects the order.
plan::tour::TourSolver tour_solver(const ResolvedPlan& plan, const ResolvedStep& step, const Objective& order,
                                   bool briefly = false);

}  // namespace clearcut::pipeline
