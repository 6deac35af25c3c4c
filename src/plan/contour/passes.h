// Makes passes, rings and paths clearing the residuals of rings, and finds the fastest of several plans: rings at
// several steps, joined to shortened paths, compared by the machine's time.
#pragma once

#include <vector>

#include "model/layer.h"
#include "plan/common/rings.h"
#include "plan/contour/contour.h"

namespace clearcut::plan::contour {

/// An area in which rings are planned, and the distance to its boundary.
struct Domain {
  Domain(Region of, const Tolerances& tol) : region(std::move(of)), clearance(region, tol) {}
  Region region;
  Clearance clearance;
};

/// Settings for planning rings.
struct RingJob {
  double radius = 0;       ///< radius of the cutter, mm
  double first_level = 0;  ///< mm from the wall to the first rings
  double reserve = 0;      ///< mm of first_level only for rounding: exact fits need not keep this part
  double margin = 0;       ///< mm; overlap for clearing the residuals of rings
  StepOf step;
  ResidualRule residuals = ResidualRule::kOurs;
  StepOf sharp_step;  ///< of contours whose reflex corners stay corners; none: corners are rounded
  /// Whether contours with sharp corners must be proven to leave nothing; those that do are rounded instead.
  bool leaves_nothing = false;
  std::vector<Path> fit_lines;  ///< lines on which the cutter just fits: the same for any step
};

/// Whether the contours of a domain keep its reflex corners: those of areas without arcs, if the job asks for it.
bool keeps_corners(const Domain& domain, const RingJob& job);

/// Lines on which the cutter just fits in the domains at job.first_level.
std::vector<Path> fit_lines_of(const std::vector<Domain>& domains, const RingJob& job);

struct RingPasses {
  std::vector<Pass> passes;
  /// Of each domain: whether its contours keep reflex corners. Those that were to leave nothing but do are rounded.
  std::vector<bool> with_corners;
};

/// The passes of all domains: rings, each after the ring around it, with detours into corners in which they would
/// leave material; then passes along ridges of the medial axis; then lines on which the cutter just fits. Components
/// have the same numbers for any step.
RingPasses ring_passes(const std::vector<Domain>& domains, const RingJob& job, const Tolerances& tol);

/// Replaces the passes of each component of `result` by one continuous path if this path is proven to clear
/// everything and is faster. `job`: the settings with which the passes were made.
void shorten_passes(const std::vector<Domain>& domains, RingJob job, const Layer& layer,
                    const ContourOptions& options, const Tolerances& tol, LayerPasses& result);

}  // namespace clearcut::plan::contour
