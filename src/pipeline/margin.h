// How far a machine may leave the path of a program that was planned or checked.
#pragma once

#include "model/results/margin.h"
#include "pipeline/check.h"
#include "pipeline/run.h"

namespace clearcut::pipeline {

/// Of what was found with these options; see verify::margin_of.
Margin margin_of(const PlanResult& result, const resolve::PlanOptions& options, const MarginBounds& bounds);
Margin margin_of(const CheckResult& result, const resolve::PlanOptions& options, const MarginBounds& bounds);

/// One sentence for people: "holds for 0.0034 mm of machine error: ...".
std::string margin_line(const Margin& margin);

}  // namespace clearcut::pipeline
