// Rings and the passes that clear what they leave, as passes. Used by the planner alone.
#pragma once

#include <vector>

#include "model/pass.h"
#include "plan/common/rings.h"
#include "plan/contour/contour.h"

namespace clearcut::plan::contour {

/// An area in which rings are planned, with its clearance.
struct Domain {
  Domain(Region of, const Tolerances& tol) : region(std::move(of)), clearance(region, tol) {}
  Region region;
  Clearance clearance;
};

struct RingJob {
  double radius = 0;       ///< of the cutter, mm
  double first_level = 0;  ///< of the rings at the wall, mm
  double reserve = 0;      ///< mm; as Layer::reserve
  double margin = 0;       ///< mm by which what rings leave is cleared more than just so
  StepOf step;
  ResidualRule residuals = ResidualRule::kOurs;
};

/// Passes of all domains: rings, parents first, with ears where they would leave material in corners; then
/// passes on ridges; then lines on which the cutter just fits. Components are numbered alike whatever the
/// step.
std::vector<Pass> ring_passes(const std::vector<Domain>& domains, const RingJob& job, const Tolerances& tol);

}  // namespace clearcut::plan::contour
