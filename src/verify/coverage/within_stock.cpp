#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "base/tolerances.h"
#include "verify/coverage/feature_work.h"
#include "verify/part/finished_part.h"

namespace clearcut::verify {
namespace {

/// mm2; a loop enclosing less was wholly outside of the stock.
constexpr double kNoArea = 1e-9;

double nearest_between(double low, double high, double value) {
  if (value < low + kRoundingMm) return low;
  return value > high - kRoundingMm ? high : value;
}

Vec2 nearest_in(const Box& box, Vec2 p) {
  return {nearest_between(box.min.x, box.max.x, p.x), nearest_between(box.min.y, box.max.y, p.y)};
}

/// Parameters at which the edge crosses the lines through the sides of the box, with 0 and 1, ascending.
std::vector<double> cuts_at_sides(const Edge& edge, const Box& box) {
  const Box reach = edge.box().grown(1);
  std::vector<double> cuts{0, 1};
  const auto cut_at = [&](Vec2 a, Vec2 b) {
    for (const Vec2 p : intersections(edge, Edge::line(a, b))) cuts.push_back(nearest(edge, p).t);
  };
  for (const double x : {box.min.x, box.max.x}) cut_at({x, reach.min.y}, {x, reach.max.y});
  for (const double y : {box.min.y, box.max.y}) cut_at({reach.min.x, y}, {reach.max.x, y});
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

/// The loop with all parts outside of the box moved onto the box's edge.
Loop moved_into(const Box& box, const Loop& loop) {
  Loop moved;
  for (const Edge& edge : loop) {
    const std::vector<double> cuts = cuts_at_sides(edge, box);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const Edge piece = cuts.size() == 2 ? edge : edge.part(cuts[i], cuts[i + 1]);
      const Vec2 from = moved.empty() ? nearest_in(box, piece.from) : moved.back().to;
      const Vec2 to = nearest_in(box, piece.to);
      if (from == to) continue;
      moved.push_back(box.contains(piece.at(0.5)) ? Edge{from, to, piece.center, piece.turn}
                                                  : Edge::line(from, to));
    }
  }
  if (!moved.empty()) moved.back().to = moved.front().from;
  return moved;
}

/// Number of the side of the box along which the edge runs: 0 left, 1 right, 2 lower, 3 upper; -1: none.
int side_of(const Edge& edge, const Box& box) {
  if (edge.is_arc()) return -1;
  const double sides[] = {box.min.x, box.max.x, box.min.y, box.max.y};
  for (int side = 0; side < 4; ++side) {
    const double from = side < 2 ? edge.from.x : edge.from.y, to = side < 2 ? edge.to.x : edge.to.y;
    if (from == sides[side] && to == sides[side]) return side;
  }
  return -1;
}

/// Appends edges along one side (`upright`: in y) after removing the parts run to and fro.
void append_without_returns(const std::vector<Edge>& edges, bool upright, std::vector<Edge>& out) {
  const auto along = [upright](Vec2 p) { return upright ? p.y : p.x; };
  // Balance by place: number of edges leaving upwards minus number of edges arriving.
  std::map<double, std::pair<Vec2, int>> turns;
  for (const Edge& edge : edges) {
    turns.try_emplace(along(edge.from), edge.from, 0).first->second.second += 1;
    turns.try_emplace(along(edge.to), edge.to, 0).first->second.second -= 1;
  }
  int going = 0;
  for (auto at = turns.begin(); at != turns.end() && std::next(at) != turns.end(); ++at) {
    going += at->second.second;
    const Vec2 here = at->second.first, there = std::next(at)->second.first;
    for (int i = 0; i < std::abs(going); ++i)
      out.push_back(going > 0 ? Edge::line(here, there) : Edge::line(there, here));
  }
}

/// The loops formed by edges with exactly meeting ends.
std::vector<Loop> chained(const std::vector<Edge>& edges) {
  const auto key = [](Vec2 p) { return std::make_pair(p.x, p.y); };
  std::multimap<std::pair<double, double>, Edge> from;
  for (const Edge& edge : edges) from.emplace(key(edge.from), edge);
  std::vector<Loop> loops;
  while (!from.empty()) {
    Loop loop;
    for (auto next = from.begin(); next != from.end(); next = from.find(key(loop.back().to))) {
      loop.push_back(next->second);
      from.erase(next);
      if (loop.back().to == loop.front().from) break;
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// Loops that do not cross, with coincident opposite edges along the sides of the box removed: areas joined only
/// outside of the box become separate.
Regions parted(const std::vector<Loop>& loops, const Box& box) {
  std::vector<Edge> edges, along[4];
  for (const Loop& loop : loops) {
    for (const Edge& edge : loop) {
      const int side = side_of(edge, box);
      (side < 0 ? edges : along[side]).push_back(edge);
    }
  }
  for (int side = 0; side < 4; ++side) append_without_returns(along[side], side < 2, edges);
  std::vector<Loop> outers, islands;
  for (Loop& loop : chained(edges)) {
    const double enclosed = signed_area(loop);
    if (std::abs(enclosed) > kNoArea) (enclosed > 0 ? outers : islands).push_back(std::move(loop));
  }
  Regions regions;
  for (const Loop& outer : outers) {
    std::vector<Loop> own;
    std::copy_if(islands.begin(), islands.end(), std::back_inserter(own),
                 [&](const Loop& island) { return contains(outer, island.front().at(0.5)); });
    regions.push_back(Region::from_valid_loops(outer, std::move(own)));
  }
  return regions;
}

}  // namespace

Regions within_stock(const Regions& target, const std::optional<Box>& stock) {
  const Box reach = box(target);
  if (!stock || reach.empty()) return target;
  const Box whole = stock->grown(FinishedPart::kProbe);
  if (whole.contains(reach.min) && whole.contains(reach.max)) return target;
  Regions within;
  for (const Region& region : target) {
    std::vector<Loop> moved{moved_into(*stock, region.outer())};
    for (const Loop& island : region.islands()) moved.push_back(moved_into(*stock, island));
    for (Region& one : parted(moved, *stock)) within.push_back(std::move(one));
  }
  return within;
}

}  // namespace clearcut::verify
