// Meetings of loops with themselves or each other: loops that touch themselves are split, and non-crossing loops
// become regions by their depth of nesting.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/region.h"
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

/// Splits `loop` at every place of `touches` (its meetings with itself): edges are divided there, and each part
/// returning to a place becomes a separate loop. Together they bound the same area under the even-odd rule. Cost O(n
/// log n).
std::vector<Loop> split_at(const Loop& loop, const std::vector<Meeting>& touches);

/// A point inside `loop`, as far from the loop as found by a short search.
Vec2 inner_point(const Loop& loop);

/// For every loop the loops around it, from the largest to the smallest. The loops must not cross;
/// they may touch. Cost O(n log n + n k), k edges level with one place.
std::vector<std::vector<int>> loops_about(const std::vector<Loop>& loops);

/// Regions by the even-odd rule: loops at even depth are outlines, each with the loops directly inside as islands. In
/// the order of the outlines.
Regions nested(const std::vector<Loop>& loops);

}  // namespace clearcut::read
