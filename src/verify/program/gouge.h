// Depth of a move's cut into the finished part.
#pragma once

#include <optional>

#include "model/move.h"
#include "model/results/findings.h"
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

}  // namespace clearcut::verify
