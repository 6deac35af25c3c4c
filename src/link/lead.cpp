#include "link/lead.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "geometry/route/legal_area.h"

namespace clearcut::link {
namespace {

/// Tried sizes as shares of the requested size.
constexpr double kShares[] = {1, 0.5, 0.25};
/// Greatest number of edges whose middle is tried.
constexpr std::size_t kMostLeadPlaces = 48;

/// The outer end of a line must be this share of its distance from the pass away from every wall.
constexpr double kLeastOff = 0.5;
/// Radians. Angle between the pass and lines used instead of arcs.
constexpr double kLineAngle = kPi / 4;

struct Place {
  Vec2 point;
  Vec2 heading;
  double along = 0;
};

/// The start of the path and the middles of its edges, the nearest to the start first; if places have to be away from corners, the
/// middles of the edges that are long enough for it, or of the longest.
std::vector<Place> places_on(const Path& path, double from_corners) {
  double longest = 0;
  for (const Edge& edge : path) longest = std::max(longest, edge.length());
  std::vector<Place> places;
  double along = 0;
  for (const Edge& edge : path) {
    const double size = edge.length();
    if (size >= std::min(2 * from_corners, longest))
      places.push_back({edge.at(0.5), edge.tangent_at(0.5), along + size / 2});
    along += size;
  }
  const double whole = along;
  const auto apart = [whole](const Place& place) { return std::min(place.along, whole - place.along); };
  std::stable_sort(places.begin(), places.end(),
                   [&](const Place& a, const Place& b) { return apart(a) < apart(b); });
  if (places.size() > kMostLeadPlaces) places.resize(kMostLeadPlaces);
  if (from_corners <= 0) places.insert(places.begin(), {path.front().from, path.front().tangent_at(0), 0});
  return places;
}

/// The place `overlap` mm farther along the path.
Place place_beyond(const Place& place, const Path& path, double overlap) {
  if (overlap <= 0) return place;
  const Edge first = begun_at(path, std::fmod(place.along + overlap, length(path))).front();
  return {first.from, first.tangent_at(0), place.along};
}

/// The sizes tried, descending: those that would begin nearer to the pass than `room` mm are replaced by the one that begins there.
std::vector<double> sizes_down_from(double size, std::optional<Radians> angle, double room) {
  const double off =
      angle ? base::sin(angle->radians()) : 1;  // distance from the pass to the beginning, per mm of size
  std::vector<double> sizes;
  for (const double share : kShares) {
    if (share * size * off >= room) {
      sizes.push_back(share * size);
    } else {
      if (size * off >= room) sizes.push_back(room / off);
      break;
    }
  }
  return sizes;
}

bool holds_disc(const Regions& legal, Vec2 center, double radius) {
  return std::any_of(legal.begin(), legal.end(), [&](const Region& region) {
    return region.contains(center) && region.boundary_distance(center) >= radius - LegalArea::kSlack;
  });
}

/// Searches for a lead on one pass.
class LeadSearch {
 public:
  LeadSearch(const Path& path, const Regions& legal, const LeadShape& shape)
      : path_(path),
        legal_(legal),
        area_(legal),
        overlap_(std::min(shape.overlap, length(path))),
        slot_(shape.slot),
        places_(places_on(path, shape.from_corners)) {}

  /// The first fitting lead: arcs of radius `size` mm or, if there is an `angle`, lines of length `size`; smaller ones begin no
  /// nearer to the pass than `room` mm.
  std::optional<Lead> find(double size, std::optional<Radians> angle, double room) const {
    for (const double tried : sizes_down_from(size, angle, room)) {
      for (const Place& place : places_) {
        const Place end = place_beyond(place, path_, overlap_);
        for (const double side : {1.0, -1.0}) {
          const auto in = angle ? line(place, tried, side, *angle, true) : arc(place, tried, side, true);
          const auto out = angle ? line(end, tried, side, *angle, false) : arc(end, tried, side, false);
          if (in && out && is_in_slot(in->from)) return Lead{*in, *out, place.along, overlap_};
        }
      }
    }
    return std::nullopt;
  }

 private:
  /// Beside an outer corner the beginning of a lead lies farther from the pass than from the line of its edge.
  bool is_in_slot(Vec2 p) const {
    return slot_ == HUGE_VAL || std::any_of(path_.begin(), path_.end(), [&](const Edge& edge) {
             return distance(edge, p) <= slot_ + kSamePlaceMm;
           });
  }

  std::optional<Edge> arc(const Place& place, double radius, double side, bool in) const {
    const Vec2 center = place.point + left_of(place.heading) * (side * radius);
    if (!holds_disc(legal_, center, radius)) return std::nullopt;
    const Turn turn = side > 0 ? Turn::kCounterClockwise : Turn::kClockwise;
    return in ? Edge::arc(center - place.heading * radius, place.point, center, turn)
              : Edge::arc(place.point, center + place.heading * radius, center, turn);
  }

  std::optional<Edge> line(const Place& place, double size, double side, Radians angle, bool in) const {
    const Vec2 ahead = place.heading * ((in ? -1 : 1) * base::cos(angle.radians()));
    const Vec2 off =
        place.point + (ahead + left_of(place.heading) * (side * base::sin(angle.radians()))) * size;
    if (!area_.holds_line(off, place.point)) return std::nullopt;
    const double off_wall = kLeastOff * size * base::sin(angle.radians());
    if (off_wall > kSamePlaceMm && !holds_disc(legal_, off, off_wall))
      return std::nullopt;  // near another wall
    return in ? Edge::line(off, place.point) : Edge::line(place.point, off);
  }

  const Path& path_;
  const Regions& legal_;
  LegalArea area_;
  double overlap_, slot_;
  std::vector<Place> places_;
};

}  // namespace

std::optional<Lead> lead_for(const Path& path, const Regions& legal, const LeadShape& shape) {
  const LeadSearch search(path, legal, shape);
  const auto find = [&](double room) {
    auto lead = search.find(shape.size, shape.angle, room);
    return lead || shape.angle ? lead : search.find(shape.size, Radians::of(kLineAngle), room);
  };
  auto lead = find(shape.room);
  return lead || shape.room <= 0 ? lead : find(0);
}

Path begun_at(const Path& path, double along) {
  std::size_t first = 0;
  while (first + 1 < path.size() && along >= path[first].length() - kSamePlaceMm)
    along -= path[first++].length();
  const double size = path[first].length();
  if (along >= size - kSamePlaceMm) return path;
  Path out;
  const bool split = along > kSamePlaceMm;
  out.push_back(split ? path[first].part(along / size, 1) : path[first]);
  for (std::size_t i = 1; i < path.size(); ++i) out.push_back(path[(first + i) % path.size()]);
  if (split) out.push_back(path[first].part(0, along / size));
  return out;
}

Path overlapped(Path path, double overlap) {
  const std::size_t whole = path.size();
  for (std::size_t i = 0; i < whole && overlap > kSamePlaceMm; ++i) {
    const Edge edge = path[i];
    const double size = edge.length();
    path.push_back(overlap < size - kSamePlaceMm ? edge.part(0, overlap / size) : edge);
    overlap -= size;
  }
  return path;
}

}  // namespace clearcut::link
