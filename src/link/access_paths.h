// Paths for the cutter from where nothing stands to the beginning of a pass.
#pragma once

#include <optional>

#include "link/link.h"
#include "link/pass_start.h"
#include "link/work.h"

namespace clearcut::link {

/// Samples for them at one moment of the work. All is kept by reference.
class AccessPaths {
 public:
  AccessPaths(const Work& work, const LinkOptions& options, const Progress& progress)
      : work_(work), options_(options), progress_(progress) {}

  /// Whether the cutter over p is beside the stock, or in a predrilled hole.
  bool in_air(Vec2 p) const;
  /// Whether the straight path at the depth of the pass is legal and nothing of higher layers stands in it.
  bool is_clear(std::size_t item, Vec2 a, Vec2 b) const;

  /// A point beside the stock or in a predrilled hole from which a straight legal move leads to p.
  std::optional<Vec2> air_before(Vec2 p, std::size_t item) const;
  /// The nearest place beside what the layer is to remove from which a straight legal move leads to p: earlier work has
  /// cleared what stood there, but for residuals in which a cutter that may not plunge would be at fault.
  std::optional<Vec2> cleared_before(Vec2 p, std::size_t item) const;
  /// A legal path to p from beside the stock, from a predrilled hole or from cleared stock: straight, else the shortest found
  /// round corners. Empty: p is such a place.
  std::optional<Path> to(Vec2 p, std::size_t item) const;
  /// Where on a pass a straight legal move from the air may end.
  std::optional<PassStart> start_before_air(std::size_t item) const;
  /// The same from beside what is to be removed, of a few places on the ring.
  std::optional<PassStart> start_before_cleared(std::size_t item) const;
  /// The place at which the access path to `start` meets its ring first.
  std::optional<PassStart> start_on_access_path(const PassStart& start, std::size_t item) const;

 private:
  const LayerWork& layer(std::size_t item) const { return work_.layer_of(item); }
  std::optional<Vec2> hole_before(Vec2 p, std::size_t item) const;
  std::optional<Path> path_round(Vec2 from, Vec2 to, std::size_t item) const;

  const Work& work_;
  const LinkOptions& options_;
  const Progress& progress_;
};

}  // namespace clearcut::link
