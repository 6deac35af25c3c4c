// Options of areas that are filled by a line of constant width.
#pragma once

#include <optional>
#include <string>

#include "base/units.h"
#include "model/results/laid_findings.h"
#include "options/plan_options.h"

namespace clearcut::inline options {

/// Lengths in mm.
struct InfillOptions {
  double width = 0;  ///< of the line, > 0
  LayingWord word = LayingWord::kExtruded;
  double rate = 0;  ///< > 0; mm of filament for every mm of line; for a laser the power
  /// Of the strategies, or "auto": of those that cover the area the one that lays least over itself.
  std::string strategy = "auto";
  /// From line to line as for a cutter of this width; absent: the widest of some that leaves nothing bare.
  std::optional<std::string> stepover;
  double most_over = 0.1;  ///< greatest share of the covered area laid over what is covered already
  double z = 0;            ///< height of the layer
  MmPerMin feed = MmPerMin::of(1200), travel = MmPerMin::of(6000);
  PlanOptions plan;  ///< seed, threads, cancel, tol, strategies are used
};

}  // namespace clearcut::inline options
