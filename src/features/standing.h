// What still stands over the target of a workingstep when the step begins.
#pragma once

#include <vector>

#include "features/cleared.h"
#include "model/part.h"

namespace clearcut::features {

/// The material that the steps before a workingstep leave over its target.
///
/// An earlier feature has cleared its target, less the least stock that its steps so far have left on walls,
/// down to its floor and the least stock left there. Of the step's own target, what lies in its own stock to
/// leave is left out. Earlier steps of the same feature do not count, because what they left depends on the
/// cutter (resolve/left_over.h). The features' tops must have been set (stack_tops). Slivers, see
/// features/cleared.h, are left out.
class Standing {
 public:
  Standing(const Part& part, int workingstep, const Tolerances& tol);

  /// mm; where the material begins: at the feature's top, or higher if stock of earlier steps stands over it.
  /// Cost O(features) booleans.
  double top() const;

  /// The part of the target where material stands above z, in mm: what a layer down to z has to remove. Draft is
  /// left out of account: it is the outline at the top. Where something has to be removed beside the stock that
  /// the step leaves on a wall, the area goes on up to that wall. Cost O(features) booleans.
  Regions above(double z) const;

 private:
  /// The part of `regions` outside of the stock that the step itself leaves on walls.
  Regions wanted(const Regions& regions) const;

  const Feature& feature_;
  double stock_;  ///< mm; stock that the step leaves on walls
  Tolerances tol_;
  /// What earlier features would clear with no stock left on walls and floors, deepest first.
  std::vector<Cleared> by_design_;
  std::vector<Cleared> by_work_;  ///< what the steps have cleared so far, deepest first
  double start_;                  ///< mm; height of material where nothing was cleared
  bool stock_left_ = false;       ///< whether the two lists differ
};

}  // namespace clearcut::features
