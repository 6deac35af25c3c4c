// A short path whose disc covers an area: the lawn-mowing problem.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stop_token>
#include <vector>

#include "geometry/region.h"
#include "geometry/route/legal_paths.h"

namespace clearcut::plan::cover {

/// What is to be covered, with what. Lengths in mm.
struct CoverTask {
  Regions area;
  double radius = 0;  ///< of the disc
  bool closed = false;
  std::optional<Vec2> start;          ///< of open paths: where they begin
  double corner_price = 0;            ///< mm that a corner counts as, for what the machine loses there
  const LegalPaths* legal = nullptr;  ///< where the centre may be; null: everywhere
};

/// How far a search is.
struct CoverProgress {
  const char* stage = "";  ///< what was done
  double length = 0;       ///< of the path, which may leave little as yet
  int corners = 0;
  double seconds = 0;
};

struct CoverEffort {
  /// Steps of the search, counted; a million take about a fifth of a second.
  std::uint64_t steps = 20'000'000;
  double seconds = std::numeric_limits<double>::infinity();  ///< wall clock
  std::uint64_t seed = 1;
  std::stop_token cancel;
  std::function<void(const CoverProgress&)> progress;  ///< told of each stage; may be empty
};

struct CoverResult {
  std::vector<Vec2> points;  ///< of a closed path without its first point again
  double length = 0;
  bool proven = false;  ///< whether no place of the area is left, decided exactly
};

/// Finds a short path, straight from point to point, whose disc covers the area.
///
/// Method  Lattices one diameter wide, in phase with walls, are ordered by the search for tours; what they leave is cleared by
///         cheap detours. Then part of the path is taken out again and again, joined otherwise, completed and pulled taut, and
///         kept if it is shorter or, at first, hardly longer. Witness points (a raster, the boundary) decide meanwhile whether
///         all is cleared. At the end the places that lie between them are found exactly (plan/common/cover.h), become
///         witnesses, and are cleared, until there are none.
/// Error   Nothing of the area is farther from the path than the radius, but for 1e-9 mm.
/// Cost    As `effort` says. The same task, steps and seed give the same path, unless the clock ends the search.
/// Source  [fekete2023] states the problem and the instances that benchmarks/lawn_benchmark.cpp measures.
CoverResult shortest_cover(const CoverTask& task, const CoverEffort& effort);

}  // namespace clearcut::plan::cover
