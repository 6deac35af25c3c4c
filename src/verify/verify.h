// The judge: what a program does to a part. Shares distances to lines and arcs with the planner, and nothing
// else.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "base/tolerances.h"
#include "model/findings.h"
#include "model/machine.h"
#include "model/move.h"
#include "model/part.h"
#include "model/work_material.h"

namespace clearcut::verify {

struct VerifyOptions {
  Tolerances tol;
  Machine machine;
  std::optional<double> engagement_limit_deg;
  int threads = 1;
  /// A program that has run before on the same stock: what it cut is cut, what it spoiled is reported, and its lengths
  /// and times are not in the figures.
  const Toolpath* earlier = nullptr;
  std::optional<WorkMaterial> material;  ///< of the work; forces and wear are computed where it is known
  std::stop_token cancel;                ///< looked at between moves and layers
};

/// Judges `toolpath` (normally read back from program text) against `part`, whoever wrote it.
///
/// Shape   figures of all, of each workingstep and of each of its layers; faults, worst first. all.clean when
///         there is no fault. Labels and workingsteps of sections group the figures and nothing else.
/// Error   gouges exact for lines and arcs; what is left by proven upper bounds; see docs/verification.md.
/// Throws  Cancelled when options.cancel asks to stop; nothing else for a valid part; the result does not depend on options.threads.
/// Cost    O((moves + outline + cells) log n) for gouges and coverage, O(feed length / step) for the load.
Findings verify_program(const Part& part, const Toolpath& toolpath, const VerifyOptions& options);

}  // namespace clearcut::verify
