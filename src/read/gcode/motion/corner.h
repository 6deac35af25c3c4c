// Roundings and chamfers that a program states for the corner between two moves (",R" and ",C" of Fanuc and Haas, RND and CHF of
// Klartext, RND=, CHF= and CHR= of Siemens).
#pragma once

#include <optional>

#include "base/units.h"
#include "geometry/edge.h"

namespace clearcut::read::gcode {

enum class CornerKind : unsigned char {
  kRounding,      ///< an arc tangent to both moves; the size is its radius
  kChamfer,       ///< between two lines; the size is what is taken off each
  kChamferLength  ///< between two lines; the size is the length of the chamfer itself
};

struct Corner {
  CornerKind kind = CornerKind::kRounding;
  double size = 0;               ///< mm, > 0
  std::optional<MmPerMin> feed;  ///< along it; absent: as `feeds_as_next` says
  bool feeds_as_next = false;    ///< at the feed of the move behind the corner, else of the move before it
  int line = 0;                  ///< of the program
};

/// Two moves and what comes between them. Where a move is used up by the corner its edge is absent.
struct JoinedCorner {
  std::optional<Edge> before, after;
  Edge between;
};

/// `before` ends where `after` begins. Nothing where the moves make no corner, where the corner does not fit into both of them, and for chamfers
/// at arcs.
///
/// Error   1e-9 mm, where the radii at both ends of an arc agree.
std::optional<JoinedCorner> joined_corner(const Edge& before, const Edge& after, const Corner& corner);

}  // namespace clearcut::read::gcode
