#include <algorithm>
#include <utility>

#include "geometry/gaps/unite_over_gaps.h"

namespace clearcut::inline geometry {
namespace {

bool is_short(const Edge& edge, double shortest) {
  return distance(edge.from, edge.to) <= shortest && edge.length() <= shortest;
}

/// Draws the edges first to below end of a loop together, if one of their neighbours is straight: an arc keeps its
/// end.
void draw_together(Loop& loop, std::size_t first, std::size_t end, double shortest) {
  Edge &before = loop[first - 1], &after = loop[end % loop.size()];
  const Vec2 from = loop[first].from, to = loop[end - 1].to;
  if (&before == &after || distance(from, to) > shortest || (before.is_arc() && after.is_arc())) return;
  const Vec2 corner = before.is_arc() ? from : after.is_arc() ? to : lerp(from, to, 0.5);
  if (before.from == corner || after.to == corner) return;
  before.to = after.from = corner;
  loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(first),
             loop.begin() + static_cast<std::ptrdiff_t>(end));
}

Loop without_short(Loop loop, double shortest) {
  const auto stays = [&](const Edge& edge) { return !is_short(edge, shortest); };
  const auto start = std::find_if(loop.begin(), loop.end(), stays);
  if (start == loop.end()) return loop;
  std::rotate(loop.begin(), start, loop.end());
  // Backwards, so that erasing does not move edges not yet visited; the first edge is not short.
  for (std::size_t end = loop.size(); end > 1;) {
    std::size_t first = end;
    while (first > 1 && is_short(loop[first - 1], shortest)) --first;
    if (first < end) draw_together(loop, first, end, shortest);
    end = first - 1;
  }
  return loop;
}

}  // namespace

Regions without_short_edges(const Regions& regions, double shortest) {
  Regions all;
  for (const Region& region : regions) {
    std::vector<Loop> islands;
    for (const Loop& island : region.islands()) islands.push_back(without_short(island, shortest));
    all.push_back(Region::from_valid_loops(without_short(region.outer(), shortest), std::move(islands)));
  }
  return all;
}

}  // namespace clearcut::inline geometry
