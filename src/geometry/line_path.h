// Points in a row, joined by lines.
#pragma once

#include <span>

#include "geometry/edge.h"

namespace clearcut::inline geometry {

/// Lines through the points, without points that are on the line between their neighbours (within 0.001 degree)
/// or repeat the one before. Empty for fewer than two different points. Cost O(points).
Path line_path(std::span<const Vec2> points);

}  // namespace clearcut::inline geometry
