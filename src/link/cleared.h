// What the moves of a section have cleared so far beside open sides, where the legal area holds places with material.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/spatial/cell_grid.h"
#include "link/link.h"
#include "link/moves.h"
#include "link/work.h"

namespace clearcut::link {

/// Beside open sides the cutter reaches places outside of the target, where the raw block may stand at its full
/// height. There only the section's own moves have cleared anything. References are kept.
class Cleared {
 public:
  Cleared(const Work& work, const LinkOptions& options);

  /// Adds the moves made since the last call.
  void add(const MoveList& moves);

  /// Whether no material stands above the top of `layer` in the path of a cutter whose centre runs along `path`: within
  /// the target of the layer above, outside of the stock, or within the cutter's reach of earlier moves no higher
  /// than this top. Looks at places a quarter of the radius apart on the cutter's rim; passes that are not cut
  /// yet are not its matter (see Progress::clear_above).
  /// Cost  O(length / radius) queries of the target and of the moves nearby; none in closed pockets.
  bool is_clear(std::size_t layer, const Edge& path) const;

  /// Whether material higher than the top of the layer may stand beside its target. Above the first layer earlier
  /// sections have cleared what they had to.
  bool may_stand(std::size_t layer) const;

 private:
  bool holds(std::size_t layer, Vec2 p) const;

  struct Swept {
    Edge path;
    double z = 0;  ///< mm; greatest height of the tip
  };

  const Work& work_;
  const LinkOptions& options_;
  std::vector<Swept> swept_;
  BoxIndex swept_near_;
  std::size_t moves_added_ = 0;
  bool wanted_ = false;  ///< whether there are layers beside which material may stand
};

}  // namespace clearcut::link
