// Arcs and lines into and out of a closed pass, so that no mark is left where it begins.
#pragma once

#include <optional>

#include "base/units.h"
#include "geometry/region.h"

namespace clearcut::link {

struct LeadShape {
  double size = 0;               ///< mm; radius of arcs, length of lines
  std::optional<Radians> angle;  ///< of lines against the pass; absent: arcs that touch it
  double overlap = 0;            ///< mm; the pass runs this far beyond its start before it is left
};

struct Lead {
  Edge in;             ///< ends on the pass
  Edge out;            ///< begins on it
  double along = 0;    ///< mm from the start of the pass to where `in` ends
  double overlap = 0;  ///< mm from there on once more to where `out` begins
};

/// Where a lead lies in `legal`: at the start of the closed `path`, else in the middle of one of its edges, the nearest
/// first; else the same half and a quarter as large; else, for arcs, lines of 45 degrees in the same way; else nothing.
///
/// Arcs   quarter circles. Proof: the disc that one runs around keeps its radius from the boundary of the legal area,
///        to within the slack of legal moves.
/// Lines  legal along their whole length.
/// Cost O(edges of path * edges of legal) at worst.
std::optional<Lead> lead_for(const Path& path, const Regions& legal, const LeadShape& shape);

/// The closed path begun `along` mm from its start.
Path begun_at(const Path& path, double along);

/// The closed path with its first `overlap` mm once more at its end; at most once round.
Path overlapped(Path path, double overlap);

}  // namespace clearcut::link
