#include "plan/adaptive/entry_regions.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace clearcut::plan::adaptive {
namespace {

/// Share of the tool radius: room that the centre must have on each side at a later entry.
constexpr double kLeastEntryRegion = 0.15;
/// Share of a disc's area that must be uncut for an entry of its own.
constexpr double kFreshShare = 0.6;
/// Shares of the tool radius: least radius of the circle of a helix; least and greatest length of the stroke that takes its place.
constexpr double kLeastHelix = 0.05;
constexpr double kLeastStroke = 0.2;
constexpr double kLongestStroke = 4;

bool is_fresh(const Disc& disc, const std::vector<Disc>& entry_regions) {
  constexpr int kRings = 6, kSpokes = 24;
  int fresh = 0;
  for (int i = 0; i < kRings * kSpokes; ++i) {
    const int ring = i / kSpokes;
    const double rho = disc.radius * std::sqrt((ring + 0.5) / kRings);
    const Vec2 p = disc.center + direction_of(2 * kPi * (i % kSpokes) / kSpokes) * rho;
    fresh += std::none_of(entry_regions.begin(), entry_regions.end(), [&](const Disc& entry_region) {
      return distance(entry_region.center, p) < entry_region.radius;
    });
  }
  return fresh > kFreshShare * kRings * kSpokes;
}

}  // namespace

EntryRegionFinder::EntryRegionFinder(const Region& front, const Clearance& clearance,
                                     const RemainingStock& remaining, const Layer& layer, double limit,
                                     std::optional<Vec2> start)
    : front_(front),
      clearance_(clearance),
      remaining_(remaining),
      radius_(layer.tool_radius),
      reach_(layer.tool_radius + layer.wall_stock),
      depth_(layer.z_top - layer.z),
      limit_(limit),
      start_(start),
      holes_(layer.holes) {}

std::vector<Disc> EntryRegionFinder::choose() const {
  std::vector<Disc> entry_regions;
  if (const auto first = first_entry_region()) entry_regions.push_back(*first);
  for (const AxisPoint& center : clearance_.centers()) {
    if (center.clearance < reach_ || !front_.contains(center.point)) continue;
    if (remaining_.is_removed(center.point)) continue;
    const Disc disc{center.point, front_.boundary_distance(center.point) + radius_};
    if (entry_regions.empty() || (is_worth_entry(disc) && is_fresh(disc, entry_regions)))
      entry_regions.push_back(disc);
  }
  return entry_regions;
}

/// The place that was asked for, else the predrilled hole that is farthest from walls.
std::optional<Disc> EntryRegionFinder::first_entry_region() const {
  std::vector<Vec2> places;
  if (start_) places.push_back(*start_);
  std::optional<Disc> best;
  if (!start_) {
    for (const PredrilledHole& hole : holes_) places.push_back(hole.center);
  }
  for (const Vec2 place : places) {
    if (!front_.contains(place)) continue;
    const double wide = front_.boundary_distance(place);
    if (wide > kLeastEntryRegion * radius_ && (!best || wide + radius_ > best->radius))
      best = Disc{place, wide + radius_};
  }
  return best;
}

std::optional<Disc> EntryRegionFinder::widest_uncut() const {
  std::optional<Disc> best;
  for (const AxisPoint& place : clearance_.axis().points) {
    if (place.clearance < reach_ || (best && place.clearance - reach_ + radius_ <= best->radius)) continue;
    if (remaining_.is_removed(place.point) || !front_.contains(place.point)) continue;
    const double wide = front_.boundary_distance(place.point);
    if (wide > kLeastEntryRegion * radius_) best = Disc{place.point, wide + radius_};
  }
  return best;
}

double EntryRegionFinder::hole_at(Vec2 place) const {
  double radius = 0;
  for (const PredrilledHole& hole : holes_)
    radius = std::max(radius, hole.diameter / 2 - distance(hole.center, place));
  return radius;
}

std::optional<Edge> EntryRegionFinder::stroke_in_passage(const Disc& entry_region) const {
  const Vec2 from = entry_region.center;
  if (entry_region.radius - radius_ >= kLeastHelix * radius_ || begins_in_hole(hole_at(from), radius_))
    return std::nullopt;
  std::optional<Edge> longest;
  for (const AxisPoint& place : clearance_.axis().points) {
    const double far = distance(from, place.point);
    if (far < kLeastStroke * radius_ || place.clearance < reach_) continue;
    const Edge stroke =
        Edge::line(from, lerp(from, place.point, std::min(1.0, kLongestStroke * radius_ / far)));
    if ((!longest || stroke.length() > longest->length()) && remaining_.is_legal(stroke)) longest = stroke;
  }
  return longest;
}

/// Whether the disc is worth an entry: clearing it by a spiral is shorter than by arcs, which have to return, by
/// about 0.4 of the spiral's length; the entry costs a helix and a retract.
bool EntryRegionFinder::is_worth_entry(const Disc& disc) const {
  const double step = radius_ * (1 - base::cos(limit_));
  const double spiral = kPi * disc.radius * disc.radius / step;
  const double helix = 2 * depth_ / base::tan(3 * kPi / 180) + 40;
  return 0.4 * spiral > helix;
}

std::size_t nearest_entry_region(const std::vector<Disc>& entry_regions, Vec2 p) {
  const auto nearer = [&](const Disc& a, const Disc& b) {
    return distance(a.center, p) - a.radius < distance(b.center, p) - b.radius;
  };
  return static_cast<std::size_t>(std::min_element(entry_regions.begin(), entry_regions.end(), nearer) -
                                  entry_regions.begin());
}

}  // namespace clearcut::plan::adaptive
