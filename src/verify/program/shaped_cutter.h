// Cutters that cut by their shape: their depth in the finished part, and the surface they leave.
#pragma once

#include <optional>
#include <vector>

#include "geometry/spatial/cell_grid.h"
#include "model/cutter_profile.h"
#include "model/move.h"
#include "model/tool.h"
#include "verify/part/edge_tree.h"
#include "verify/part/finished_part.h"
#include "verify/program/gouge.h"

namespace clearcut::verify {

/// The deepest cut of a cutter of the given profile into the part along `move`: the shift, sideways or upwards,
/// needed to avoid it.
///
/// For each wall near, the excess is the cutter's radius at the height of the wall's top, less the distance of the
/// path from the wall; for walls with draft at the height at which the cutter comes nearest. On level moves the least
/// distance decides. On straight sloping ones beside straight walls the excess has one maximum, found by golden
/// section; else the path is halved until the excess of its lowest tip at its least distance decides. `slack`: mm;
/// shallower gouges need not be found.
std::optional<Gouge> shaped_gouge_of(const FinishedPart& part, const Move& move, const CutterProfile& cutter,
                                     double slack);

/// mm; height over its tip at which a cutter's surface is `distance` mm from its axis; nothing beyond its radius.
std::optional<double> height_at(const Tool& tool, double distance);

/// Depth of the cuts so far, place by place. Every result is a height reached by some cutter.
class CutHeights {
 public:
  /// Adds a feed move. Pointers to both are kept.
  void add(const Move& move, const Tool& tool);

  /// mm; lowest height of a cutter's surface passing over p; infinite if none did.
  double at(Vec2 p) const;

 private:
  struct Entry {
    const Move* move;
    const Tool* tool;
    double slope;  ///< slope of a cone's flank, kept to save computing a tangent; 0 for other cutters
    Box path;
  };

  static std::optional<double> height_over(const Entry& entry, double distance);
  static double least_height(const Entry& entry, Vec2 p);

  std::vector<Entry> entries_;
  BoxIndex index_{1};  ///< cells of 1 mm: smaller than most cutters
};

}  // namespace clearcut::verify
