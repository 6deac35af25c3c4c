// Runs the stages in order: read -> plan -> order -> link -> post -> read back -> verify.
#pragma once

#include "pipeline/steps/certify.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// Plans, posts and certifies a part, or the copies of it that options.copies asks for.
/// Safe to call from several threads at once, each call with its own options. Throws InputError if the options cannot
/// be met or nothing at all can be cut, Cancelled if options.cancel requests a stop.
PlanResult plan_part(const Part& part, const PlanOptions& options);

/// The same without the copies that options.copies asks for.
PlanResult plan_one_part(const Part& part, const PlanOptions& options);

/// Adds to the certified `result` the parts of the verdict other than the faults of moves (conditions of the part, unmachined
/// features, margins) and signs the program of `toolpath`.
void complete_verdict(const Toolpath& toolpath, const ResolvedPlan& plan, PlanResult& result);

}  // namespace clearcut::pipeline
