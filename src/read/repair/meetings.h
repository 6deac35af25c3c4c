// Meetings of loops with themselves or each other.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "read/repair/edge_index.h"

namespace clearcut::read {

enum class MeetingKind {
  kTouch,     ///< in a point, each staying on its side
  kCrossing,  ///< in a point, changing sides
  kOverlap    ///< along a stretch
};

struct Meeting {
  EdgeId a, b;  ///< a < b
  Vec2 at;
  MeetingKind kind = MeetingKind::kTouch;
  bool within_one_loop() const { return a.loop == b.loop; }
};

/// Every meeting of two edges, except joints of neighbours in one loop. Edges meet if they are within 1 nm; sides are
/// distinguished by directions, for equal directions by curvature; equal curvature counts as a touch. Ordered by
/// edge. Stops after `most` meetings. Throws InputError at `where` if very many long edges are so close that the
/// search would take too long. Cost O(n log n + k), k pairs of edges with overlapping boxes.
std::vector<Meeting> meetings(const std::vector<Loop>& loops, std::size_t most, const std::string& where);

/// Whether the loops separate again within `depth` mm: an end of one of the two edges is this near to the other edge,
/// and so is the whole path from this end to the meeting.
bool is_shallow(const std::vector<Loop>& loops, const Meeting& meeting, double depth);

}  // namespace clearcut::read
