// The tree of contours of one legal area: each ring region with those inside it. Used by plan_contour alone.
#pragma once

#include <functional>
#include <vector>

#include "geometry/clearance.h"
#include "geometry/region.h"

namespace clearcut::plan {

/// A piece of the medial axis along which the clearance rises from `low` to `high`. Ends carry the index of
/// their axis point, or a negative number unique within the tree where a level cut the piece.
struct AxisPiece {
  int low_id = 0;
  int high_id = 0;
  AxisPoint low;
  AxisPoint high;
};

/// One connected region of {clearance >= level}.
struct RingNode {
  Region contour;
  double level = 0;       ///< clearance of the contour, mm
  double next_level = 0;  ///< level of its children
  int parent = -1;
  int depth = 0;  ///< contours around it
  std::vector<int> children;
  std::vector<AxisPiece> gap;  ///< axis pieces inside the contour and outside the children's contours
};

/// Distance from a contour to the next ones inside it; `inside` is all of the axis inside it.
using StepOf = std::function<double(const RingNode& ring, const std::vector<AxisPiece>& inside)>;

/// clearance.inset(d) without specks that lie nearer than d to the boundary of `domain`, the region it was
/// built of: where walls meet a fillet of nearly the cutter's radius, flattening can leave some.
Regions safe_inset(const Clearance& clearance, const Region& domain, double d, const Tolerances& tol);

/// All contours from `first_level` inwards; parents before their children.
/// Cost: one inset per distinct level, and each piece of the axis once per level it spans.
std::vector<RingNode> ring_tree(const Clearance& clearance, const Region& domain, double first_level,
                                const StepOf& step_of, const Tolerances& tol);

}  // namespace clearcut::plan
