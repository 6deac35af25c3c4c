// What a plan says of itself: options that do nothing, features that no pass reaches, strategies left out.
#pragma once

#include <vector>

#include "base/diagnostics.h"
#include "model/options/resolved_plan.h"
#include "pipeline/selection/selection.h"
#include "pipeline/steps/step_work.h"

namespace clearcut::pipeline {

/// Options of one kind of strategy, asked for with another, are refused where no step can use them (InputError), and else said.
void refuse_what_means_nothing(const ResolvedPlan& plan, Diagnostics& diagnostics);

/// Says where the named strategy cuts both ways though a direction is asked for: only its passes along walls keep it.
void warn_of_both_ways(const ResolvedPlan& plan, Diagnostics& diagnostics);

/// Says which O word is written where nobody chose one: a control may hold another program by that number.
void tell_program_number(const ResolvedPlan& plan, Diagnostics& diagnostics);

/// Says of each workingstep without passes why. Throws InputError where nothing at all can be cut.
void report_what_does_not_fit(Part& part, const Selection& selection, const std::vector<StepWork>& works,
                              const ResolvedPlan& plan);

/// Says what was done before, which strategies were left out, and what the plans themselves note.
void report_notes(const Selection& selection, const std::vector<StepWork>& works, const ResolvedPlan& plan,
                  Part& part);

}  // namespace clearcut::pipeline
