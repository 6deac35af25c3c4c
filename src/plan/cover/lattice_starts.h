// First paths of a cover: tours over square lattices, one diameter wide, in phase with the area's boundary; strips.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "geometry/region.h"

namespace clearcut::plan::cover {

struct LatticeStartOptions {
  double radius = 0;  ///< mm
  bool closed = false;
  std::size_t most = 4;  ///< greatest number of paths
  double effort = 0.05;  ///< effort of each search for an order, seconds of one core
  std::uint64_t seed = 1;
  std::stop_token cancel;
  /// Bends of the shortest path if the straight move is illegal; empty function: all straight moves are legal.
  std::function<std::vector<Vec2>(Vec2 from, Vec2 to)> bends;
  std::function<bool(Vec2)> may_stand;  ///< empty: everywhere
  /// Whether orders of lattice points are compared by legal moves, which takes a path for every pair of near points; else
  /// by straight ones, and only the moves of the result get their bends.
  bool orders_by_detours = true;
};

/// Paths clearing most of the area; the first ones leave or repeat least. At least one path if the area is not empty.
std::vector<std::vector<Vec2>> lattice_starts(const Regions& area, const LatticeStartOptions& options);

/// Paths to and fro along strips no wider than the disc, all of the same width, along and across the longest walls; the
/// shortest first, at most two. They clear everything, except where a strip ends at a wall that bends within it.
std::vector<std::vector<Vec2>> strip_starts(const Regions& area, const LatticeStartOptions& options);

}  // namespace clearcut::plan::cover
