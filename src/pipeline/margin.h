// Allowed deviation of a machine from the path of a planned or checked program.
#pragma once

#include <optional>
#include <string>

#include "model/control.h"
#include "model/move.h"
#include "model/options/resolved_plan.h"
#include "model/results/findings.h"
#include "model/results/margin.h"

namespace clearcut::pipeline {

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

}  // namespace clearcut::pipeline
