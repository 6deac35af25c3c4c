// Finds access paths: from places without material, beside the stock or in a hole, to the beginning of a pass.
#pragma once

#include <optional>

#include "link/cleared.h"
#include "link/link.h"
#include "link/work.h"

namespace clearcut::link {

/// Finds access paths at one moment of the work. References are kept.
class AccessPaths {
 public:
  AccessPaths(const Work& work, const LinkOptions& options, const Progress& progress, const Cleared& cleared)
      : work_(work), options_(options), progress_(progress), cleared_(cleared) {}

  /// Whether a cutter with its centre over p is beside the stock or in a predrilled hole.
  bool in_air(Vec2 p) const;
  /// mm from the raw block to the centre of a cutter descending beside it.
  double beside_stock() const { return options_.tool_radius + options_.beside_stock; }
  /// Whether the line from a to b at the depth of the pass is legal and no material of higher layers is in its path.
  bool is_clear(std::size_t item, Vec2 a, Vec2 b) const;

  /// The nearest point beside the stock or in a predrilled hole with a straight legal move to p.
  std::optional<Vec2> air_before(Vec2 p, std::size_t item) const;
  /// The nearest point beside the target of the layer with a straight legal move to p. Earlier work has cleared this
  /// place except for residuals; a cutter that must not plunge should not descend into them.
  std::optional<Vec2> cleared_before(Vec2 p, std::size_t item) const;
  /// A legal path to p from beside the stock, from a predrilled hole or from cleared stock: straight, else
  /// the shortest one found round corners. An empty path if p itself is one of these places; nothing if there is
  /// none.
  std::optional<Path> to(Vec2 p, std::size_t item) const;
  /// A place on a pass reached by a straight legal move from the air.
  std::optional<PassStart> start_before_air(std::size_t item) const;
  /// A place on a ring, among a few candidates, reached by a straight legal move from beside the target.
  std::optional<PassStart> start_before_cleared(std::size_t item) const;
  /// The place at which the access path to `start` first meets the ring, possibly before `start`.
  std::optional<PassStart> start_on_access_path(const PassStart& start, std::size_t item) const;

 private:
  /// Whether no material of higher layers, or beside open sides, is in the way along `path` at the depth of the pass.
  bool is_free(std::size_t item, const Edge& path) const;
  const LayerWork& layer(std::size_t item) const { return work_.layer_of(item); }
  std::optional<Vec2> hole_before(Vec2 p, std::size_t item) const;
  std::optional<Path> path_round(Vec2 from, Vec2 to, std::size_t item) const;

  const Work& work_;
  const LinkOptions& options_;
  const Progress& progress_;
  const Cleared& cleared_;
};

}  // namespace clearcut::link
