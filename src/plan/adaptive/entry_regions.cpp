#include "plan/adaptive/entry_regions.h"

#include <algorithm>
#include <cmath>

namespace clearcut::plan::adaptive {
namespace {

/// Tool radii that the centre must have to each side where an entry is made later.
constexpr double kLeastRoom = 0.15;
/// Share of a disc that must be uncut for an entry of its own.
constexpr double kFreshShare = 0.6;

bool is_fresh(const Disc& disc, const std::vector<Disc>& rooms) {
  constexpr int kRings = 6, kSpokes = 24;
  int fresh = 0;
  for (int i = 0; i < kRings * kSpokes; ++i) {
    const int ring = i / kSpokes;
    const double rho = disc.radius * std::sqrt((ring + 0.5) / kRings);
    const Vec2 p = disc.center + direction_of(2 * kPi * (i % kSpokes) / kSpokes) * rho;
    fresh += std::none_of(rooms.begin(), rooms.end(),
                          [&](const Disc& room) { return distance(room.center, p) < room.radius; });
  }
  return fresh > kFreshShare * kRings * kSpokes;
}

}  // namespace

RoomFinder::RoomFinder(const Region& front, const Clearance& clearance, const Ground& ground,
                       const Layer& layer, double limit, std::optional<Vec2> start)
    : front_(front),
      clearance_(clearance),
      ground_(ground),
      radius_(layer.tool_radius),
      reach_(layer.tool_radius + layer.wall_stock),
      depth_(layer.z_top - layer.z),
      limit_(limit),
      start_(start),
      holes_(layer.holes) {}

std::vector<Disc> RoomFinder::choose() const {
  std::vector<Disc> rooms;
  if (const auto first = first_room()) rooms.push_back(*first);
  for (const AxisPoint& center : clearance_.centers()) {
    if (center.clearance < reach_ || !front_.contains(center.point)) continue;
    if (ground_.is_removed(center.point)) continue;
    const Disc disc{center.point, front_.boundary_distance(center.point) + radius_};
    if (rooms.empty() || (is_worth_entry(disc) && is_fresh(disc, rooms))) rooms.push_back(disc);
  }
  return rooms;
}

/// At the place asked for, else at the hole that is farthest from walls.
std::optional<Disc> RoomFinder::first_room() const {
  std::vector<Vec2> places;
  if (start_) places.push_back(*start_);
  std::optional<Disc> best;
  if (!start_) {
    for (const PredrilledHole& hole : holes_) places.push_back(hole.center);
  }
  for (const Vec2 place : places) {
    if (!front_.contains(place)) continue;
    const double wide = front_.boundary_distance(place);
    if (wide > kLeastRoom * radius_ && (!best || wide + radius_ > best->radius))
      best = Disc{place, wide + radius_};
  }
  return best;
}

std::optional<Disc> RoomFinder::widest_uncut() const {
  std::optional<Disc> best;
  for (const AxisPoint& place : clearance_.axis().points) {
    if (place.clearance < reach_ || (best && place.clearance - reach_ + radius_ <= best->radius)) continue;
    if (ground_.is_removed(place.point) || !front_.contains(place.point)) continue;
    const double wide = front_.boundary_distance(place.point);
    if (wide > kLeastRoom * radius_) best = Disc{place.point, wide + radius_};
  }
  return best;
}

double RoomFinder::hole_at(Vec2 place) const {
  double radius = 0;
  for (const PredrilledHole& hole : holes_)
    radius = std::max(radius, hole.diameter / 2 - distance(hole.center, place));
  return radius;
}

/// A spiral saves the returns of arcs, about a quarter of their time; an entry costs a helix and a hop.
bool RoomFinder::is_worth_entry(const Disc& disc) const {
  const double step = radius_ * (1 - std::cos(limit_));
  const double spiral = kPi * disc.radius * disc.radius / step;
  const double helix = 2 * depth_ / std::tan(3 * kPi / 180) + 40;
  return 0.4 * spiral > helix;
}

std::size_t nearest_room(const std::vector<Disc>& rooms, Vec2 p) {
  const auto nearer = [&](const Disc& a, const Disc& b) {
    return distance(a.center, p) - a.radius < distance(b.center, p) - b.radius;
  };
  return static_cast<std::size_t>(std::min_element(rooms.begin(), rooms.end(), nearer) - rooms.begin());
}

}  // namespace clearcut::plan::adaptive
