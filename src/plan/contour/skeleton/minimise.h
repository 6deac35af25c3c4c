// Shortens rubber bands while witnesses hold them. Used by the planner alone.
#pragma once

#include <memory>

#include "plan/contour/skeleton/bands.h"
#include "plan/contour/skeleton/tighten.h"

namespace clearcut::plan::contour {

/// How one round of Newton steps goes.
struct Pull {
  int steps = 0;
  double reach = 0;       ///< longest first step, shares of the radius
  double last_reach = 0;  ///< longest last step, as a share of the first
  double soft = 0;        ///< stiffness of the first step, 1 / radius
  double tension = 1;     ///< force of the bands
};
/// Moves the vertices of bands, and the witnesses that keep to the middle between two of them.
///
/// Method  an augmented Lagrangian with Newton steps, see the source file.
/// Cost    O(steps * (vertices + witnesses near the limit)).
class BandMinimiser {
 public:
  /// Both must live as long as this.
  BandMinimiser(Bands& paths, const TightenJob& job);
  ~BandMinimiser();
  BandMinimiser(const BandMinimiser&) = delete;
  BandMinimiser& operator=(const BandMinimiser&) = delete;

  /// Newton steps, at first wide and soft, at last small and stiff. `limit`: mm from which on witnesses hold. Bands
  /// stay in the legal area.
  void relax(const Pull& pull, double limit);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clearcut::plan::contour
