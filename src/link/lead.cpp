#include "link/lead.h"

#include <algorithm>
#include <cmath>

#include "toolpath/legal_area.h"

namespace clearcut {
namespace {

/// Of the radius asked for.
constexpr double kShares[] = {1, 0.5, 0.25};
/// Edges whose middle is tried.
constexpr std::size_t kMostPlaces = 48;
/// mm. Nearer to the end of an edge is its end.
constexpr double kJoint = 1e-6;

struct Place {
  Vec2 point;
  Vec2 heading;
  double along = 0;
};

/// The start and the middles of edges, nearest to the start first.
std::vector<Place> places_on(const Path& path) {
  std::vector<Place> places;
  double along = 0;
  for (const Edge& edge : path) {
    const double size = edge.length();
    places.push_back({edge.at(0.5), edge.tangent_at(0.5), along + size / 2});
    along += size;
  }
  const double whole = along;
  const auto apart = [whole](const Place& place) { return std::min(place.along, whole - place.along); };
  std::stable_sort(places.begin(), places.end(),
                   [&](const Place& a, const Place& b) { return apart(a) < apart(b); });
  if (places.size() > kMostPlaces) places.resize(kMostPlaces);
  places.insert(places.begin(), {path.front().from, path.front().tangent_at(0), 0});
  return places;
}

bool holds_disc(const Regions& legal, Vec2 center, double radius) {
  return std::any_of(legal.begin(), legal.end(), [&](const Region& region) {
    return region.contains(center) && region.boundary_distance(center) >= radius - LegalArea::kSlack;
  });
}

std::optional<Lead> lead_at(const Place& place, const Regions& legal, double radius) {
  for (const double side : {1.0, -1.0}) {
    const Vec2 center = place.point + left_of(place.heading) * (side * radius);
    if (!holds_disc(legal, center, radius)) continue;
    const Turn turn = side > 0 ? Turn::kCounterClockwise : Turn::kClockwise;
    const Vec2 from = center - place.heading * radius, to = center + place.heading * radius;
    return Lead{Edge::arc(from, place.point, center, turn), Edge::arc(place.point, to, center, turn),
                place.along};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Lead> lead_for(const Path& path, const Regions& legal, double radius) {
  const auto places = places_on(path);
  for (const double share : kShares) {
    for (const Place& place : places) {
      if (auto lead = lead_at(place, legal, share * radius)) return lead;
    }
  }
  return std::nullopt;
}

Path begun_at(const Path& path, double along) {
  std::size_t first = 0;
  while (first + 1 < path.size() && along >= path[first].length() - kJoint) along -= path[first++].length();
  const double size = path[first].length();
  if (along >= size - kJoint) return path;
  Path out;
  const bool split = along > kJoint;
  out.push_back(split ? path[first].part(along / size, 1) : path[first]);
  for (std::size_t i = 1; i < path.size(); ++i) out.push_back(path[(first + i) % path.size()]);
  if (split) out.push_back(path[first].part(0, along / size));
  return out;
}

}  // namespace clearcut
