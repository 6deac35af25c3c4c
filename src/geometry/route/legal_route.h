// Paths between two places that stay where the cutter's centre may be.
#pragma once

#include <optional>
#include <vector>

#include "geometry/route/legal_area.h"

namespace clearcut::inline geometry {

/// Finds short legal paths. Keeps a reference to `area`, which must be built from `regions`.
class LegalRoutes {
 public:
  LegalRoutes(const Regions& regions, const LegalArea& area);

  /// A path from a to b inside the legal area: the straight one where it is legal, else along the boundaries
  /// that are in its way, the shorter way round each, pulled taut. Both places must be legal. Nothing when
  /// they lie in different regions. Short, not always the shortest. Cost O(edges + vertices of the path squared).
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
