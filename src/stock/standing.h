// What still stands over the target of a workingstep when its turn comes.
#pragma once

#include <vector>

#include "model/part.h"
#include "stock/cleared.h"

namespace clearcut::stock {

/// The material that the steps before a workingstep leave over its target.
///
/// An earlier feature has cleared its target less the least stock that its steps so far have left on walls, down to its floor
/// and the least stock left there. Of the step's own target, what lies in its own stock is not asked for. Earlier steps of the
/// same feature do not count: what they left is a matter of the cutter (resolve/left_over.h). Tops must be
/// stacked. Slivers as in stock/cleared.h are left out.
class Standing {
 public:
  Standing(const Part& part, int workingstep, const Tolerances& tol);

  /// Where the material begins: the feature's top, or higher as far as stock of earlier steps stands over it. Cost O(features)
  /// booleans.
  double top() const;

  /// The part of the target where material stands above z: what a layer down to z really has to remove (the fishhead's
  /// FACE3 begins at z -2, but only on a small part; elsewhere at -12). At the top outline; up to the walls,
  /// over the step's own stock. Same cost.
  Regions above(double z) const;

 private:
  /// What is wanted of `regions`: no more than slivers may lie in the step's own stock.
  Regions wanted(const Regions& regions) const;

  const Feature& feature_;
  double stock_;  ///< mm, of the step on its walls
  Tolerances tol_;
  std::vector<Cleared>
      by_design_;  ///< by earlier features with nothing left on their walls and floors, deepest first
  std::vector<Cleared> by_work_;  ///< as the steps have left them, deepest first
  double start_;                  ///< where nothing was cleared
  bool stock_left_ = false;       ///< whether the two differ
};

}  // namespace clearcut::stock
