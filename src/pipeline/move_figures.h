// Results of verification for each single move of a program.
#pragma once

#include <vector>

#include "model/control.h"
#include "model/move.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

struct MoveFigures {
  double time_s = 0;               ///< kinematic, with the waits before the move
  double max_engagement_deg = 0;   ///< 0 without a cut, and for entries
  double mean_engagement_deg = 0;  ///< over the length in contact
  double cutting_mm = 0;           ///< length in contact with material
  double air_mm = 0;               ///< length below the stock's top without contact
};

/// The times of all moves, section after section, s. Cost O(moves).
std::vector<double> times_of_moves(const Part& part, const Toolpath& toolpath, const ControlTable& control,
                                   const resolve::PlanOptions& options);

/// Figures of all moves, section after section; `part`, `toolpath` and `control` are those of a PlanResult or
/// CheckResult. Throws Cancelled. Cost as the engagement of the certificate: O(feed length / step).
std::vector<MoveFigures> figures_of_moves(const Part& part, const Toolpath& toolpath,
                                          const ControlTable& control, const resolve::PlanOptions& options);

}  // namespace clearcut::pipeline
