// Random flat parts as they are drawn in a CAD: a plate with pockets and holes, and what is to come out of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/random.h"
#include "geometry/region.h"

namespace clearcut::test_support {

enum class CadShapeKind { kPlate, kPocket, kHole };

/// One closed outline, counter-clockwise, mm.
struct CadShape {
  CadShapeKind kind = CadShapeKind::kPlate;
  Loop outline;
  std::optional<double> diameter;  ///< of circles
  Vec2 center;                     ///< of circles
};

/// The plate first.
struct CadPart {
  std::vector<CadShape> shapes;
  Box box() const;
};

/// A plate 70 to 230 mm wide with at least one pocket and one hole, its corner somewhere near the origin.
CadPart random_cad_part(Random& random);

/// A drawing of a part as one CAD writes it.
struct CadDrawing {
  std::string file;  ///< its ending says the format
  std::string text;
  bool says_roles = false;     ///< layers' names say what is what
  bool holes_are_cut = false;  ///< the roles say profiles for all that is inside the plate
  bool round = true;           ///< circles are circles; else polygons
};

}  // namespace clearcut::test_support
