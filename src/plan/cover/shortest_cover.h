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

/// The area to be covered, and the disc. Lengths in mm.
struct CoverTask {
  Regions area;
  double radius = 0;  ///< radius of the disc
  bool closed = false;
  std::optional<Vec2> start;          ///< start of open paths
  double corner_price = 0;            ///< cost of a corner in mm, for the machine's loss of time
  const LegalPaths* legal = nullptr;  ///< legal area of the centre; null: everywhere
};

/// Progress of a search.
struct CoverProgress {
  const char* stage = "";  ///< the completed stage
  double length = 0;       ///< length of the path, which may still leave small places
  int corners = 0;
  double seconds = 0;
};

struct CoverEffort {
  /// Steps of the search, counted; a million take some 0.3 s. A first path that clears all is made in any
  /// case, in steps proportional to the area.
  std::uint64_t steps = 20'000'000;
  double seconds = std::numeric_limits<double>::infinity();  ///< wall clock
  /// A quick search for paths with few corners: it begins with strips, and ends with the first path that clears all.
  bool brief = false;
  std::uint64_t seed = 1;
  std::stop_token cancel;
  std::function<void(const CoverProgress&)> progress;  ///< called at each stage; may be empty
};

struct CoverResult {
  std::vector<Vec2> points;  ///< points; a closed path does not repeat its first point
  double length = 0;
  bool proven = false;      ///< whether no place of the area is left, decided exactly
  std::uint64_t steps = 0;  ///< counted steps
};

/// Finds a short path of straight moves along which a disc covers the area.
///
/// Method  Lattices one diameter wide, in phase with walls, are ordered by the search for tours; uncleared places are
///         cleared by cheap detours. Then part of the path is repeatedly removed, joined differently, completed and
///         pulled taut; the change is kept if the path is shorter or, at first, hardly longer. Witness points (a
///         raster, the boundary) decide meanwhile whether everything is cleared. At the end uncleared places between
///         the witnesses are found exactly (plan/common/cover.h), become witnesses, and are cleared, until there are
///         none.
/// Error   No point of the area is farther from the path than the radius, to within 1e-9 mm.
/// Cost    Given by `effort`, and O(n log n) for n square diameters and edges of the area. The same task, steps and seed give the same path, unless the clock ends the search.
/// Source  [fekete2023] states the problem and the instances measured by benchmarks/lawn_benchmark.cpp.
CoverResult shortest_cover(const CoverTask& task, const CoverEffort& effort);

}  // namespace clearcut::plan::cover
