// Planning of one workingstep by one strategy, the chosen plans of all workingsteps as one toolpath, and the messages
// of a plan.
#pragma once

#include <cstdint>
#include <vector>

#include "base/diagnostics.h"
#include "model/move.h"
#include "model/options/resolved_plan.h"
#include "pipeline/selection/selection.h"
#include "pipeline/selection/strategies.h"
#include "pipeline/steps/step_work.h"

namespace clearcut::pipeline {

/// Candidates for each workingstep.
std::vector<SelectionStep> selection_steps(const ResolvedPlan& plan, const StrategyTable& strategies);

/// The plan of a strategy for one workingstep, within a number of work steps. Throws OutOfWork if it needs more.
StepPlan plan_step(const StepWork& work, const StrategyCandidate& candidate, const ResolvedPlan& job,
                   std::uint64_t most_work);

/// The plan of a candidate, or of a faster rival. Throws as plan_step().
StepPlan fastest_plan(const StepWork& work, const StrategyCandidate& candidate, const ResolvedPlan& job,
                      const StrategyTable& strategies, std::uint64_t most_work);

/// Joins the sections in their order, or in a short one if the order is free, with feeds allowed by the material
/// around each move. `over_rests`: rapids stay above all material left by the passes.
Toolpath toolpath_of(const Selection& selection, const ResolvedPlan& plan, bool over_rests);

/// Options of one kind of strategy, requested with another, are refused if no step can use them (InputError), and
/// otherwise reported.
void refuse_what_means_nothing(const ResolvedPlan& plan, Diagnostics& diagnostics);

/// Warns if the named strategy cuts in both directions although a direction is requested: only its passes along walls
/// keep it.
void warn_of_both_ways(const ResolvedPlan& plan, Diagnostics& diagnostics);

/// Reports the O word written if the user chose none: the control may already store another program of this number.
void tell_program_number(const ResolvedPlan& plan, Diagnostics& diagnostics);

/// Reports the reason for each workingstep without passes. Throws InputError if nothing at all can be cut.
void report_what_does_not_fit(Part& part, const Selection& selection, const std::vector<StepWork>& works,
                              const ResolvedPlan& plan);

/// Reports earlier work, strategies left out, and the notes of the plans.
void report_notes(const Selection& selection, const std::vector<StepWork>& works, const ResolvedPlan& plan,
                  Part& part);

}  // namespace clearcut::pipeline
