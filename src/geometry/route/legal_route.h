// Paths between two places within the legal area of the cutter's centre.
#pragma once

#include <optional>
#include <vector>

#include "geometry/route/legal_area.h"

namespace clearcut::inline geometry {

/// Finds short legal paths. Keeps a reference to `area`, which must be built from `regions`.
class LegalRoutes {
 public:
  LegalRoutes(const Regions& regions, const LegalArea& area);

  /// A path from a to b inside the legal area: the straight one if legal, else along the boundaries that block it,
  /// around the shorter side of each, pulled taut. Both places must be legal. Nothing if they are in different
  /// regions. Short, not always the shortest. Cost O(edges + vertices of the path squared).
  std::optional<Path> between(Vec2 a, Vec2 b) const;

 private:
  struct Crossing {
    double t = 0;  ///< along the straight path
    Vec2 point;
    std::size_t loop = 0;
    std::size_t edge = 0;
  };
  std::vector<Crossing> crossings(Vec2 a, Vec2 b) const;
  Path around(const Crossing& out, const Crossing& in) const;
  Path taut(Vec2 a, const Path& path) const;

  const LegalArea& area_;
  std::vector<Loop> loops_;
  std::vector<std::vector<Box>> boxes_;
};

}  // namespace clearcut::inline geometry
