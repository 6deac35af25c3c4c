// Depth of a move's cut into the finished part, by cylinders and by cutters that cut by their shape, and the surface
// these leave.
#pragma once

#include <optional>
#include <vector>

#include "geometry/spatial/cell_grid.h"
#include "model/cutter_profile.h"
#include "model/move.h"
#include "model/results/findings.h"
#include "model/tool.h"
#include "verify/part/edge_tree.h"
#include "verify/part/finished_part.h"

namespace clearcut::verify {

/// The part of a tool that intrudes into the part.
enum class CutterPart {
  kEnd,
  kNeck,  ///< neck of a T-slot cutter
  kDisc   ///< upper side of a T-slot cutter's disc
};

struct Gouge {
  double depth = 0;    ///< mm; the smallest shift, sideways or upwards, that would have avoided the gouge
  Vec2 point;          ///< place of the tool's centre
  double z = 0;        ///< height of its tip
  bool floor = false;  ///< a floor was cut too deep, not a wall
  int feature = -1;    ///< feature whose outline was cut; -1: a floor or the top of the stock
  CutterPart by = CutterPart::kEnd;
};

/// The deepest cut of a flat-ended cutter of `radius` mm into the part along `move`.
///
/// Exact for lines and arcs at one height: radius - distance(path, wall). For changing z, the move is checked in
/// pieces between the heights of floors, each at its lowest tip; near walls with draft the pieces are halved until
/// the error is less than kLeanError. `slack`: mm by which floors may be cut too deep. `free_start`: the move is
/// known to begin outside the part.
///
/// Cost    O(log n + walls near) for n walls.
std::optional<Gouge> gouge_of(const FinishedPart& part, const Move& move, double radius, double slack,
                              bool free_start);

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
