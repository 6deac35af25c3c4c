// Where loops meet themselves or each other.
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

/// Every place where two edges meet, except where neighbours of one loop join. Edges meet when they come
/// within 1 nm; sides are told apart by directions, equal ones by how they bend; what bends alike counts as a touch. Ordered by edge.
/// Stops after `most` meetings. Throws InputError at `where` when very many long edges lie so close that
/// the search would not end in time. Cost O(n log n + k), k pairs of edges with overlapping boxes.
std::vector<Meeting> meetings(const std::vector<Loop>& loops, std::size_t most, const std::string& where);

/// Whether the loops part again within `depth` mm: an end of one of the two edges lies that near to the
/// other edge, and so does the way from there to the meeting.
bool is_shallow(const std::vector<Loop>& loops, const Meeting& meeting, double depth);

}  // namespace clearcut::read
