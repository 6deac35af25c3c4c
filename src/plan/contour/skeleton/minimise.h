// Shortens elastic bands while witnesses hold them.
#pragma once

#include <memory>

#include "plan/contour/skeleton/bands.h"
#include "plan/contour/skeleton/tighten.h"

namespace clearcut::plan::contour {

/// Settings of one series of Newton steps.
struct Pull {
  int steps = 0;
  double reach = 0;       ///< longest first step, as a share of the tool radius
  double last_reach = 0;  ///< longest last step, as a share of the longest first step
  double soft = 0;        ///< stiffness of the witnesses in the first step, 1 / radius
  double tension = 1;     ///< force shortening the bands; 0: bands only give way to witnesses
};
/// Moves the vertices of bands, and the witnesses kept in the middle between two bands.
///
/// Method  An augmented Lagrangian with Newton steps, see the source file.
/// Cost    O(steps * (vertices + witnesses near the limit)).
class BandMinimiser {
 public:
  /// Both are kept by reference.
  BandMinimiser(Bands& paths, const TightenJob& job);
  ~BandMinimiser();
  BandMinimiser(const BandMinimiser&) = delete;
  BandMinimiser& operator=(const BandMinimiser&) = delete;

  /// Makes Newton steps: long and soft at first, short and stiff at the end. A witness pulls a band farther than
  /// `limit` mm away. Bands stay in the legal area.
  void relax(const Pull& pull, double limit);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clearcut::plan::contour
