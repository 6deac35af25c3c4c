// Figures in addition to a program's findings: contours of the published methods, for their result file and the
// certificate; allowed deviation of a machine from the path; results of verification for each single move.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/control.h"
#include "model/move.h"
#include "model/options/resolved_plan.h"
#include "model/results/findings.h"
#include "model/results/margin.h"
#include "model/runs/check_result.h"
#include "report/result.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// Contours of each section planned by contours, with coefficients if a published method derives its steps from
/// angles (CPO-kappa, CPO-rho).
std::vector<ContourLevels> contours_of(const Toolpath& toolpath, const ResolvedPlan& plan);

/// Notes the coefficient computed by the rule of CPO-rho, the result of that paper.
void report_rho(const std::vector<ContourLevels>& contours, const ResolvedPlan& plan, Part& part);

/// A program as read.
struct ProgramRead {
  const Part& part;
  const Toolpath& toolpath;
  const ControlTable& control;
};

/// The margin if `plan` requests one; see verify::margin_of. A margin smaller than requested is an open condition of
/// `findings`.
std::optional<Margin> margin_asked(const ProgramRead& program, const ResolvedPlan& plan, Findings& findings);

/// One sentence for people: "margin: holds for 0.0034 mm of machine error; ...".
std::string margin_line(const Margin& margin);

/// The times of all moves, section after section, s. Cost O(moves).
std::vector<double> times_of_moves(const Part& part, const Toolpath& toolpath, const ControlTable& control,
                                   const PlanOptions& options);

/// Figures of all moves, section after section; `part`, `toolpath` and `control` are those of a PlanResult or
/// CheckResult. Throws Cancelled. Cost as the engagement of the certificate: O(feed length / step).
std::vector<MoveFigures> figures_of_moves(const Part& part, const Toolpath& toolpath,
                                          const ControlTable& control, const PlanOptions& options);

}  // namespace clearcut::pipeline
