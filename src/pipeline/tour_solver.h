// The optimiser behind the strategy "tour": objectives by name, for grids of a layer.
#pragma once

#include <functional>
#include <string>

#include "order/objective.h"
#include "order/problem.h"
#include "order/solve.h"
#include "plan/tour/tour.h"
#include "resolve/plan_options.h"

namespace clearcut::pipeline {

/// Makes the objective of a name such as "length"; throws InputError for names it does not know.
using ObjectiveMaker = std::function<order::ObjectivePtr(const std::string& name)>;

/// "turns", or weights: "1:length,20:turns". Throws InputError.
order::ObjectivePtr objective_from(const std::string& text, const ObjectiveMaker& make);

/// Seconds on a machine that accelerates: length / feed, and at every corner what slowing down to the speed of
/// the junction (Grbl's rule, see kinematic_time) and speeding up again loses. As exact as kinematic_time
/// where moves are long enough to reach the feed, and priced from the few moves that an exchange touches.
order::ObjectivePtr machine_time_objective(const Machine& machine, MmPerMin feed);

/// An open path through the points of a grid, along its legal ways.
order::Problem grid_problem(const plan::tour::TourTask& task);

/// The text's genetic algorithm on any problem, ended by options.time_s, too. Few points are ordered exactly.
order::Tour published_order(const order::Problem& problem, const order::Objective& objective,
                            const resolve::PlanOptions& options);

/// Orders grids by options.objective, with options.published_solver where given. Without options.time_s the same points give the same order, however
/// busy the machine. `briefly`: with a fifth of the usual search, which is seldom felt in the order.
plan::tour::TourSolver tour_solver(const resolve::PlanOptions& options, MmPerMin feed, bool briefly = false);

}  // namespace clearcut::pipeline
