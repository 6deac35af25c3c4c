// Results of the published contour methods, for their result file and the certificate.
#pragma once

#include <vector>

#include "model/options/resolved_plan.h"
#include "report/result.h"

namespace clearcut::pipeline {

/// Contours of each section planned by contours, with coefficients if a published method derives its steps from
/// angles (CPO-kappa, CPO-rho).
std::vector<report::ContourLevels> contours_of(const Toolpath& toolpath, const ResolvedPlan& plan);

/// Notes the coefficient computed by the rule of CPO-rho, the result of that paper.
void report_rho(const std::vector<report::ContourLevels>& contours, const ResolvedPlan& plan, Part& part);

}  // namespace clearcut::pipeline
