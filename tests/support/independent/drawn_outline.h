// Distances to outlines as they are drawn: lines and arcs by the definition of the bulge. Shares nothing with the geometry under
// test but points.
#pragma once

#include <vector>

#include "geometry/region.h"

namespace clearcut::test_support {

/// One side of an outline: a line, or an arc of less than half a circle.
struct Side {
  Vec2 from, to;
  double sweep = 0;  ///< 4 atan(bulge); 0: a line
  Vec2 center{};
  double radius = 0;
};

/// The sides of a closed outline.
std::vector<Side> sides_of(const std::vector<BulgeVertex>& corners);

/// A point along a side, with the direction away from what a counter-clockwise outline bounds.
struct Sample {
  Vec2 at, outwards;
};

/// Adds points of a side at most `step` apart, none at its ends.
void add_samples(const Side& side, double step, std::vector<Sample>& samples);

double to_segment(Vec2 p, Vec2 a, Vec2 b);

/// Distance to the outline, negative within it.
double signed_distance(Vec2 p, const std::vector<Side>& outline);

}  // namespace clearcut::test_support
