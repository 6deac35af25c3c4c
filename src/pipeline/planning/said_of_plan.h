// Messages of a plan: options without effect, features without passes, strategies left out.
#pragma once

#include <vector>

#include "base/diagnostics.h"
#include "model/options/resolved_plan.h"
#include "pipeline/selection/selection.h"
#include "pipeline/steps/step_work.h"

namespace clearcut::pipeline {

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
