// The judge: what a program does to a part. Shares distances to lines and arcs with the planner, and nothing
// else.
#pragma once

#include <functional>
#include <optional>

#include "base/tolerances.h"
#include "part/part.h"
#include "toolpath/findings.h"
#include "toolpath/machine.h"
#include "toolpath/move.h"

namespace clearcut {

struct VerifyOptions {
  Tolerances tol;
  Machine machine;
  std::optional<double> engagement_limit_deg;
  int threads = 1;
};

/// Judges `toolpath` (normally read back from program text) against `part`, whoever wrote it.
Findings verify(const Part& part, const Toolpath& toolpath, const VerifyOptions& options);

}  // namespace clearcut
