// The tree of offset contours of one legal area: each with the contours next inside it.
#pragma once

#include <functional>
#include <vector>

#include "geometry/region.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::plan {

/// A piece of the medial axis along which the clearance rises from `low` to `high`. Its ends are numbered: by
/// the axis point's index, or, at a cut of the axis by a contour's level, by a negative number that occurs nowhere
/// else in the tree.
struct AxisPiece {
  int low_id = 0;
  int high_id = 0;
  AxisPoint low;
  AxisPoint high;
};

/// One connected region of the points with clearance >= level, and its place in the tree.
struct RingNode {
  Region contour;         ///< the region; its boundary is the contour
  double level = 0;       ///< clearance of the contour, mm
  double next_level = 0;  ///< clearance of the contours next inside it, mm
  int parent = -1;
  int depth = 0;  ///< number of contours around it
  std::vector<int> children;
  std::vector<AxisPiece> gap;  ///< the medial axis between this contour and those of its children
};

/// mm from a contour to the next ones inside it; `inside` is the medial axis inside the contour.
using StepOf = std::function<double(const RingNode& ring, const std::vector<AxisPiece>& inside)>;

/// The medial axis below the clearance `level`, mm, cut and numbered as ring_tree does.
std::vector<AxisPiece> axis_below(const Clearance& clearance, double level);

/// clearance.inset(d) without specks nearer than d mm to the boundary of `domain`, the region from which the
/// clearance was computed: flattening can leave specks at joints of walls with a fillet of nearly the cutter's
/// radius.
Regions safe_inset(const Clearance& clearance, const Region& domain, double d, const Tolerances& tol);

/// All contours from the clearance `first_level`, mm, inwards; parents come before their children. Cost: one
/// inset for each distinct level, and one visit of each axis piece for each of its levels.
std::vector<RingNode> ring_tree(const Clearance& clearance, const Region& domain, double first_level,
                                const StepOf& step_of, const Tolerances& tol);

}  // namespace clearcut::plan
