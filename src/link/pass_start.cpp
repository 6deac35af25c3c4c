#include "link/pass_start.h"

#include <limits>

namespace clearcut::link {

Path rotated_to(const Path& path, const PassStart& start) {
  const Edge& edge = path[start.edge];
  const double margin = 1e-6 / edge.length();
  Path out;
  std::size_t first = start.edge;
  const bool split = start.t > margin && start.t < 1 - margin;
  if (split) out.push_back(edge.part(start.t, 1));
  if (split || start.t >= 1 - margin) ++first;
  const std::size_t whole = split ? path.size() - 1 : path.size();
  for (std::size_t i = 0; i < whole; ++i) out.push_back(path[(first + i) % path.size()]);
  if (split) out.push_back(edge.part(0, start.t));
  return out;
}

PassStart nearest_start(const Pass& pass, Vec2 p) {
  PassStart best;
  if (!pass.closed) {
    best.backwards =
        pass.reversible && distance(pass.path.back().to, p) < distance(pass.path.front().from, p);
    best.point = best.backwards ? pass.path.back().to : pass.path.front().from;
    return best;
  }
  double nearest_distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pass.path.size(); ++i) {
    const auto on = nearest(pass.path[i], p);
    if (on.distance >= nearest_distance) continue;
    nearest_distance = on.distance;
    best = {on.point, i, on.t, false};
  }
  return best;
}

}  // namespace clearcut::link
