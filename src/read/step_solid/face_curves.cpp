#include "read/step_solid/face_curves.h"

#include <algorithm>
#include <map>

namespace clearcut::read {
namespace {

struct ByPlace {
  bool operator()(Vec2 a, Vec2 b) const { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};

Vec2 middle_of(const Path& path) {
  const Edge& edge = path[path.size() / 2];
  return path.size() % 2 ? edge.at(0.5) : edge.from;
}

bool is_reverse(const Path& a, const Path& b) {
  return a.front().from == b.back().to && a.back().to == b.front().from &&
         distance(middle_of(a), middle_of(b)) < 10 * kSamePlace;
}

}  // namespace

std::vector<std::size_t> unpaired(const std::vector<const Path*>& curves) {
  std::map<Vec2, std::vector<std::size_t>, ByPlace> starting;
  std::vector<bool> gone(curves.size(), false);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    auto& candidates = starting[curves[i]->back().to];
    const auto mate = std::find_if(candidates.begin(), candidates.end(), [&](std::size_t j) {
      return !gone[j] && is_reverse(*curves[i], *curves[j]);
    });
    if (mate == candidates.end()) {
      starting[curves[i]->front().from].push_back(i);
    } else {
      gone[i] = gone[*mate] = true;
    }
  }
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (!gone[i]) left.push_back(i);
  return left;
}

std::vector<RawCurve> chained(const std::vector<Path>& curves, const std::string& source) {
  std::map<Vec2, std::vector<std::size_t>, ByPlace> starting;
  for (std::size_t i = curves.size(); i-- > 0;) starting[curves[i].front().from].push_back(i);
  std::vector<bool> used(curves.size(), false);
  std::vector<RawCurve> loops;
  for (std::size_t first = 0; first < curves.size(); ++first) {
    if (used[first]) continue;
    RawCurve loop;
    loop.source = source;
    for (std::size_t at = first;;) {
      used[at] = true;
      loop.edges.insert(loop.edges.end(), curves[at].begin(), curves[at].end());
      if (loop.edges.back().to == loop.edges.front().from) break;
      auto& next = starting[loop.edges.back().to];
      while (!next.empty() && used[next.back()]) next.pop_back();
      if (next.empty()) break;
      at = next.back();
    }
    loop.closed = loop.edges.back().to == loop.edges.front().from;
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace clearcut::read
