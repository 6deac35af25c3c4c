#include "plan/contour/ring_band.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <queue>

namespace clearcut::plan::contour {
namespace {

/// mm. Rests thinner than this are due to rounding.
constexpr double kNothing = 0.002;
/// mm of clearance per mm of axis; a branch of smaller slope is a ridge.
constexpr double kFlat = 0.01;
/// Share of the radius. A ring is expected only if the clearance exceeds its level by this; nearer to a centre the
/// ring would be a speck.
constexpr double kRoom = 0.02;
/// mm. Precision of the widest step.
constexpr double kStepPrecision = 1e-4;
constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

const char* name_of(RestCause cause) {
  switch (cause) {
    case RestCause::kNone:
      return "nothing";
    case RestCause::kCorner:
      return "sharper corner";
    case RestCause::kNeck:
      return "neck";
    case RestCause::kCentre:
      return "centre";
    case RestCause::kRidge:
      break;
  }
  return "ridge";
}

RingBand::RingBand(const std::vector<AxisPiece>& inside, double level, double radius)
    : floor_(level + radius + kNothing), level_(level), radius_(radius) {
  std::map<int, std::size_t> known;
  const double ceiling = level + 2 * radius;
  const auto vertex = [&](int id, const AxisPoint& at) {
    const auto [it, added] = known.emplace(id, vertices_.size());
    if (added) vertices_.push_back({at.point, at.clearance, 0, {}});
    return it->second;
  };
  for (const auto& piece : inside) {
    if (piece.high.clearance <= floor_ || piece.low.clearance >= ceiling) continue;
    AxisPoint low = piece.low;
    std::size_t a = 0;
    if (low.clearance < floor_) {
      const double t = (floor_ - low.clearance) / (piece.high.clearance - low.clearance);
      low = {lerp(low.point, piece.high.point, t), floor_};
      a = vertices_.size();
      vertices_.push_back({low.point, floor_, 0, {}});
    } else {
      a = vertex(piece.low_id, low);
    }
    const std::size_t b = vertex(piece.high_id, piece.high);
    if (a == b) continue;
    vertices_[a].links.push_back(links_.size());
    vertices_[b].links.push_back(links_.size());
    links_.push_back({a, b, distance(low.point, piece.high.point)});
  }
  // Pieces above 2 radius are left out; axis points leading to them count as rising without end.
  for (const auto& piece : inside) {
    if (piece.low.clearance < ceiling) continue;
    const auto at = known.find(piece.low_id);
    if (at != known.end()) vertices_[at->second].summit = kFar;
  }
  find_summits();
}

/// Sets `summit` for every vertex. Links go upwards, so one visit in descending order is enough.
void RingBand::find_summits() {
  std::vector<std::size_t> order(vertices_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return vertices_[a].clearance > vertices_[b].clearance; });
  for (const std::size_t v : order) {
    vertices_[v].summit = std::max(vertices_[v].summit, vertices_[v].clearance);
    for (const std::size_t i : vertices_[v].links) {
      if (links_[i].low == v)
        vertices_[v].summit = std::max(vertices_[v].summit, vertices_[links_[i].high].summit);
    }
  }
}

/// mm; shortest path along the axis from every vertex to the clearance `level`.
std::vector<double> RingBand::lengths_to(double level) const {
  std::vector<double> lengths(vertices_.size(), kFar);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto reach = [&](std::size_t v, double length) {
    if (length >= lengths[v]) return;
    lengths[v] = length;
    open.emplace(length, v);
  };
  // Along a ridge at the level itself, which leads to wider places, a ring would be narrower than rounding.
  const auto has_ring = [&](std::size_t v) {
    const double summit = vertices_[v].summit, room = std::min(kRoom * radius_, (summit - floor_) / 2);
    return vertices_[v].clearance >= level + kNothing && summit - level >= room;
  };
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    if (has_ring(v)) reach(v, 0);
  }
  for (const auto& link : links_) {
    const double low = vertices_[link.low].clearance, high = vertices_[link.high].clearance;
    if (low < level + kNothing && has_ring(link.high))
      reach(link.low, std::max(0.0, link.length * (level - low) / (high - low)));
  }
  while (!open.empty()) {
    const auto [length, v] = open.top();
    open.pop();
    if (length > lengths[v] || has_ring(v)) continue;
    for (const std::size_t i : vertices_[v].links) {
      const std::size_t u = links_[i].low == v ? links_[i].high : links_[i].low;
      reach(u, length + links_[i].length);
    }
  }
  return lengths;
}

RestCause RingBand::cause_at(std::size_t v, const std::vector<double>& lengths) const {
  if (lengths[v] < kFar) {
    const auto& links = vertices_[v].links;
    const auto rises =
        std::count_if(links.begin(), links.end(), [&](std::size_t i) { return links_[i].low == v; });
    if (rises == 0) return RestCause::kCentre;
    return rises >= 2 ? RestCause::kNeck : RestCause::kCorner;
  }
  // Goes uphill to the highest point; if the last link is flat, the path is a ridge.
  std::size_t top = v, by = links_.size();
  for (bool climbed = true; climbed;) {
    climbed = false;
    for (const std::size_t i : vertices_[top].links) {
      if (links_[i].low != top) continue;
      top = links_[i].high;
      by = i;
      climbed = true;
      break;
    }
  }
  double flat = 0;
  for (const std::size_t i : vertices_[top].links) {
    const double rise = vertices_[links_[i].high].clearance - vertices_[links_[i].low].clearance;
    if (rise < kFlat * links_[i].length) flat += links_[i].length;
  }
  return by < links_.size() && flat > kFlat * radius_ ? RestCause::kRidge : RestCause::kCentre;
}

Rest RingBand::worst(double step, double reach) const {
  const double level = level_ + step;
  const auto lengths = lengths_to(level);
  Rest worst;
  std::size_t at = vertices_.size();
  const auto consider = [&](std::size_t v, double length) {
    if (length <= reach || length <= worst.length) return;
    worst.length = length;
    at = v;
  };
  // The distance of a point beside the axis from the axis equals the difference of their clearances.
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    if (lengths[v] > 0) consider(v, lengths[v] + vertices_[v].clearance - floor_);
  }
  for (const auto& link : links_) {
    if (lengths[link.high] == 0 || lengths[link.low] == kFar || lengths[link.high] == kFar) continue;
    const double meeting = (lengths[link.high] + link.length - lengths[link.low]) / 2;
    const double climb = (vertices_[link.high].clearance - vertices_[link.low].clearance) / link.length;
    consider(link.low,
             lengths[link.low] + meeting + vertices_[link.low].clearance + meeting * climb - floor_);
  }
  if (at < vertices_.size()) {
    worst.where = vertices_[at].point;
    worst.cause = cause_at(at, lengths);
  }
  return worst;
}

double RingBand::widest_step(double reach) const {
  double low = radius_, high = radius_ + reach;
  if (worst(high, reach).cause == RestCause::kNone) return high;
  while (high - low > kStepPrecision) {
    const double middle = (low + high) / 2;
    (worst(middle, reach).cause == RestCause::kNone ? low : high) = middle;
  }
  return low;
}

}  // namespace clearcut::plan::contour
