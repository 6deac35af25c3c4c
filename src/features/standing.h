// Material remaining over the target of a workingstep when the step begins.
#pragma once

#include <vector>

#include "features/cleared.h"
#include "model/part.h"

namespace clearcut::features {

/// The material left over the target of a workingstep by earlier steps.
///
/// An earlier feature has cleared its target, less the least stock that its steps so far have left on walls,
/// down to its floor and the least stock left there. The part of the step's target within its own stock to leave is
/// left out. Earlier steps of the same feature do not count, because the material left by them depends on the cutter
/// (resolve/left_over.h). The features' tops must have been set (stack_tops). Slivers, see features/cleared.h, are
/// left out.
class Standing {
 public:
  Standing(const Part& part, int workingstep, const Tolerances& tol);

  /// mm; height of the top of the material: the feature's top, or higher if stock of earlier steps is left above it.
  /// Cost O(features) booleans.
  double top() const;

  /// The part of the target with material above z, in mm: the area that a layer down to z must clear. Draft is
  /// ignored: the outline is that at the top. If material must be removed beside the stock that the step leaves on a
  /// wall, the area extends up to that wall. Cost O(features) booleans.
  Regions above(double z) const;

 private:
  /// The part of `regions` outside of the stock to leave of the step itself on walls.
  Regions wanted(const Regions& regions) const;

  const Feature& feature_;
  double stock_;  ///< mm; stock to leave on walls of the step
  Tolerances tol_;
  /// Areas that earlier features would clear without stock left on walls and floors, deepest first.
  std::vector<Cleared> by_design_;
  std::vector<Cleared> by_work_;  ///< areas cleared by the steps so far, deepest first
  double start_;                  ///< mm; height of material in uncleared areas
  bool stock_left_ = false;       ///< whether the two lists differ
};

}  // namespace clearcut::features
