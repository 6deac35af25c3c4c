// Arcs into and out of a closed pass that touch it, so that no mark is left where it begins.
#pragma once

#include <optional>

#include "geometry/region.h"

namespace clearcut {

struct Lead {
  Edge in;           ///< a quarter circle that ends on the pass
  Edge out;          ///< one that begins there
  double along = 0;  ///< mm from the start of the pass to that place
};

/// Where a lead of `radius` mm lies in `legal`: at the start of the closed `path`, else in the middle of one of its edges,
/// the nearest first; else the same with half and a quarter of the radius; else nothing. Proof: the disc that both
/// arcs run around keeps its radius from the boundary of the legal area, to within the slack of legal moves.
/// Cost O(edges of path * edges of legal) at worst.
std::optional<Lead> lead_for(const Path& path, const Regions& legal, double radius);

/// The closed path begun `along` mm from its start.
Path begun_at(const Path& path, double along);

}  // namespace clearcut
