// Material remaining over the target of a workingstep when the step begins: areas that earlier work has cleared, and
// the height of the top of each feature's material.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "base/tolerances.h"
#include "geometry/box.h"
#include "geometry/region.h"
#include "model/part.h"

namespace clearcut::features {

/// An area from which everything above `floor_z`, mm, has been removed.
struct Cleared {
  Cleared(double floor, Regions cleared);

  double floor_z = 0;
  Regions area;
  Box extent;  ///< box of `area`
};

/// mm. Mean thickness below which a remainder of `target` after subtractions counts as a sliver along nominally
/// coincident outlines: 0.05 mm; for targets hardly wider than that, half of their own width.
double sliver_width(const Regions& target);
bool is_sliver(const Region& region, double width);

/// The regions `standing` minus the cleared area.
Regions without(const Regions& standing, const Cleared& cleared, const Tolerances& tol);

/// mm; height of the highest material over `target`: `start` if some part of the target was not cleared.
/// Subtracts the areas one after the other until nothing of the target is left; the floor of the last one is
/// the height. Cost O(areas) booleans.
double top_over(const Regions& target, const std::vector<Cleared>& deepest_first, double start,
                const Tolerances& tol);

/// mm; height of the highest material beside a tool that stands in `target` when the first `steps` workingsteps are done:
/// over the target, and as far beside it as the tool above its flutes needs room. Flutes need to reach up to there.
/// Earlier features count as cleared down to their floors. Cost O(features) booleans for each feature at worst.
double top_beside_tool(const Part& part, std::size_t steps, const Regions& target, const Tool& tool,
                       const Tolerances& tol);

/// The material left over the target of a workingstep by earlier steps.
///
/// An earlier feature has cleared its target, less the least stock that its steps so far have left on walls,
/// down to its floor and the least stock left there. The part of the step's target within its own stock to leave is
/// left out. Earlier steps of the same feature do not count, because the material left by them depends on the cutter
/// (resolve/left_over.h). The features' tops must have been set (stack_tops). Slivers, see features/standing.h, are
/// left out.
///
/// Steps that may leave material anywhere, as published grids do, have cleared nothing for certain.
class Standing {
 public:
  /// Whether a workingstep, by its place in the workplan, leaves no material that its cutter reaches.
  using ClearsAll = std::function<bool(int workingstep)>;
  Standing(const Part& part, int workingstep, const Tolerances& tol, const ClearsAll& clears_all = {});

  /// mm; height of the top of the material: the feature's top, or higher if stock of earlier steps is left above it.
  /// Cost O(features) booleans.
  double top() const;

  /// The part of the target with material above z, in mm: the area that a layer down to z must clear. Draft is
  /// ignored: the outline is that at the top. If material must be removed beside the stock that the step leaves on a
  /// wall, the area extends up to that wall. Cost O(features) booleans.
  Regions above(double z) const;

 private:
  /// The target over the block: beside it nothing has stood, whatever earlier features have not cleared there.
  Regions in_block() const;
  /// The part of `regions` outside of the stock to leave of the step itself on walls.
  Regions wanted(const Regions& regions) const;

  const Feature& feature_;
  double stock_;  ///< mm; stock to leave on walls of the step
  Tolerances tol_;
  std::optional<Box> block_;  ///< outline of the block, if it is known
  /// Areas that earlier features would clear without stock left on walls and floors, deepest first.
  std::vector<Cleared> by_design_;
  std::vector<Cleared> by_work_;  ///< areas cleared by the steps so far, deepest first
  double start_;                  ///< mm; height of material in uncleared areas
  bool stock_left_ = false;       ///< whether the two lists differ
  bool uncertain_ = false;        ///< whether an earlier step may have left material anywhere
};

/// Whether the depth of the feature follows from its width: spots and countersinks end below their top, wherever this is.
bool is_cone(const Feature& feature);

/// Sets top_z of every feature, in workplan order, to the height of the material left over its target by earlier
/// features. Reports tops that differ from the declared ones by more than tol.join_gap.
void stack_tops(Part& part, const Tolerances& tol);
/// The same heights, mm, one for each feature, without setting or reporting anything. Features outside the
/// workplan keep their declared top. Slivers thinner than 0.05 mm in the mean do not count. Cost O(features)
/// booleans for each feature at worst.
std::vector<double> stacked_tops(const Part& part, const Tolerances& tol);

}  // namespace clearcut::features
