#include "read/repair/splitting.h"

#include <algorithm>
#include <map>
#include <utility>

namespace clearcut::read {
namespace {

/// mm. Places nearer to a vertex than this are the vertex.
constexpr double kAtVertex = 4e-9;

using Key = std::pair<double, double>;

/// `edge` divided at the places within it.
void append_divided(const Edge& edge, std::vector<Vec2> places, Loop& out) {
  std::vector<std::pair<double, Vec2>> cuts;
  for (const Vec2 place : places) {
    if (distance(place, edge.from) > kAtVertex && distance(place, edge.to) > kAtVertex) {
      cuts.emplace_back(nearest(edge, place).t, place);
    }
  }
  std::sort(cuts.begin(), cuts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Edge rest = edge;
  for (const auto& [t, place] : cuts) {
    if (place == rest.from) continue;
    out.push_back({rest.from, place, edge.center, edge.turn});
    rest.from = place;
  }
  if (rest.from != rest.to) out.push_back(rest);
}

/// All vertices at one place get its exact coordinates.
void snap(Loop& loop, const std::vector<Meeting>& touches) {
  for (const Meeting& touch : touches) {
    for (const EdgeId id : {touch.a, touch.b}) {
      const auto i = static_cast<std::size_t>(id.edge);
      Edge& edge = loop[i];
      if (distance(edge.from, touch.at) <= kAtVertex) {
        edge.from = touch.at;
        loop[(i + loop.size() - 1) % loop.size()].to = touch.at;
      }
      if (distance(edge.to, touch.at) <= kAtVertex) {
        edge.to = touch.at;
        loop[(i + 1) % loop.size()].from = touch.at;
      }
    }
  }
}

}  // namespace

std::vector<Loop> split_at(const Loop& loop, const std::vector<Meeting>& touches) {
  Loop snapped = loop;
  snap(snapped, touches);
  std::map<int, std::vector<Vec2>> places_on;
  for (const Meeting& touch : touches) {
    places_on[touch.a.edge].push_back(touch.at);
    places_on[touch.b.edge].push_back(touch.at);
  }
  Loop divided;
  for (std::size_t i = 0; i < snapped.size(); ++i) {
    const auto found = places_on.find(static_cast<int>(i));
    append_divided(snapped[i], found == places_on.end() ? std::vector<Vec2>{} : found->second, divided);
  }
  // Walk along; whenever a place is met again, the part in between is a loop.
  std::vector<Loop> loops;
  Loop open;
  std::map<Key, std::size_t> starts;
  for (const Edge& edge : divided) {
    starts[{edge.from.x, edge.from.y}] = open.size();
    open.push_back(edge);
    const auto again = starts.find({edge.to.x, edge.to.y});
    if (again == starts.end() || again->second >= open.size() || open[again->second].from != edge.to) {
      continue;
    }
    const auto first = open.begin() + static_cast<std::ptrdiff_t>(again->second);
    if (open.end() - first >= 2) loops.emplace_back(first, open.end());
    open.erase(first, open.end());
  }
  return loops;
}

}  // namespace clearcut::read
