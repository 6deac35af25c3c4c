#include "verify/coverage/within_stock.h"

#include <algorithm>
#include <cmath>

#include "verify/part/finished_part.h"

namespace clearcut::verify {
namespace {

/// mm2; a loop that encloses less lay wholly beyond the stock.
constexpr double kNoArea = 1e-9;

Vec2 nearest_in(const Box& box, Vec2 p) {
  return {std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y)};
}

/// Parameters at which the edge meets the lines through the sides of the box, with 0 and 1, ascending.
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

/// The loop with all that lies beyond the box moved onto its edge.
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

}  // namespace

Regions within_stock(const Regions& target, const std::optional<Box>& stock) {
  const Box reach = box(target);
  if (!stock || reach.empty()) return target;
  const Box whole = stock->grown(FinishedPart::kProbe);
  if (whole.contains(reach.min) && whole.contains(reach.max)) return target;
  const auto encloses = [](const Loop& loop) { return std::abs(signed_area(loop)) > kNoArea; };
  Regions within;
  for (const Region& region : target) {
    Loop outer = moved_into(*stock, region.outer());
    if (!encloses(outer)) continue;
    std::vector<Loop> islands;
    for (const Loop& island : region.islands()) {
      Loop moved = moved_into(*stock, island);
      if (encloses(moved)) islands.push_back(std::move(moved));
    }
    within.push_back(Region::from_valid_loops(std::move(outer), std::move(islands)));
  }
  return within;
}

}  // namespace clearcut::verify
