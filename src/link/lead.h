// Leads: arcs and lines into and out of a closed pass, so that no mark is left on the wall at its beginning.
#pragma once

#include <cmath>
#include <optional>

#include "base/units.h"
#include "geometry/region.h"

namespace clearcut::link {

struct LeadShape {
  double size = 0;               ///< mm; radius of arcs, length of lines
  std::optional<Radians> angle;  ///< between lines and the pass; absent: arcs tangent to the pass
  double overlap = 0;            ///< mm; the pass continues this far beyond its start before the lead-out
  /// mm; if greater than 0 the lead is at a place this far from the ends of its edge: a control that shifts the pass begins
  /// and ends it square to the edge, which beside an inside corner is beyond the other edge's shifted path.
  double from_corners = 0;
  /// mm; earlier steps have cut down to this far beside the pass. Nearer to it a lead goes down into what they left.
  double room = 0;
  /// mm beside the pass where the slot of earlier steps ends: no lead begins farther out.
  double slot = HUGE_VAL;
};

struct Lead {
  Edge in;             ///< lead-in; ends on the pass
  Edge out;            ///< lead-out; begins on the pass
  double along = 0;    ///< mm along the pass from its start to the end of `in`
  double overlap = 0;  ///< mm from there, once round, to the beginning of `out`
};

/// Places a lead inside `legal`. At the start of the closed `path` (unless it has to be away from corners), else in the middle of
/// one of its edges, the nearest first; else half and a quarter as large, but beginning no nearer to the pass than `room`; else, instead
/// of arcs, lines of 45 degrees by the same rules; else any of these that begins nearer; else nothing.
///
/// Arcs   Quarter circles. The disc of the arc keeps its radius from the boundary of the legal area, to within the
///        tolerance of legal moves; this proves the arc legal.
/// Lines  Legal along their whole length.
/// Cost   O(edges of path * edges of legal) at worst.
std::optional<Lead> lead_for(const Path& path, const Regions& legal, const LeadShape& shape);

/// The closed path, begun `along` mm from its start.
Path begun_at(const Path& path, double along);

/// The closed path with its first `overlap` mm repeated at its end; at most once round.
Path overlapped(Path path, double overlap);

}  // namespace clearcut::link
