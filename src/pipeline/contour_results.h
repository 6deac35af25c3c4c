// What the published contour methods came to, for their result file and the certificate.
#pragma once

#include <vector>

#include "model/options/resolved_plan.h"
#include "report/result.h"

namespace clearcut::pipeline {

/// Contours of each section that was planned by contours, with the coefficients where a published method takes its steps from
/// angles (CPO-kappa, CPO-rho).
std::vector<report::ContourLevels> contours_of(const Toolpath& toolpath, const ResolvedPlan& plan);

/// Notes the coefficient that the rule of CPO-rho came to, which is that paper's result.
void report_rho(const std::vector<report::ContourLevels>& contours, const ResolvedPlan& plan, Part& part);

}  // namespace clearcut::pipeline
