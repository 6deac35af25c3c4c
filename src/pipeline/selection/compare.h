// Every strategy and rival on one part, judged alike.
#pragma once

#include "report/text_table.h"
#include "resolve/plan_options.h"

namespace clearcut::pipeline {

/// One row a strategy: lengths, times (kinematic; and CPO-rho eq. 9 with tau = 0.177 s), what is left, load,
/// verdict; the fastest clean row is marked. Strategies that cannot plan the part say why. Throws InputError where none can.
report::TextTable compare(const Part& part, const resolve::PlanOptions& options);

/// CPO-rho eq. 9: T = sum L / V_f + 2 (1 + nd) tau, nd the number of discontinuities, tau = 0.177 s.
double published_time(double naive_s, int discontinuities);

}  // namespace clearcut::pipeline
