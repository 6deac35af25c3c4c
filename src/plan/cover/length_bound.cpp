#include "plan/cover/length_bound.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

#include "base/units.h"

namespace clearcut::plan::cover {
namespace {

/// Tried distances between witnesses, in radii; each is larger than the previous one by kWider.
constexpr double kNearest = 3, kWider = 1.25;
constexpr int kDistances = 16;
/// Distance, in radii, of the boundary points among which witnesses are chosen.
constexpr double kBoundaryPitch = 0.5;
constexpr std::size_t kMostPlaces = 20000;

std::vector<Vec2> boundary_places(const Regions& area, double radius) {
  double length = 0;
  for (const Edge& edge : edges_of(area)) length += edge.length();
  const double pitch = std::max(kBoundaryPitch * radius, length / static_cast<double>(kMostPlaces));
  std::vector<Vec2> places;
  for (const Edge& edge : edges_of(area))
    for (double along = 0; along < edge.length(); along += pitch)
      places.push_back(edge.at(along / edge.length()));
  return places;
}

/// The places, in the given order, at least `apart` from all places chosen before.
std::vector<Vec2> chosen_places(const std::vector<Vec2>& places, double apart) {
  std::vector<Vec2> chosen;
  for (const Vec2 p : places) {
    if (std::all_of(chosen.begin(), chosen.end(), [&](Vec2 q) { return distance(p, q) >= apart; }))
      chosen.push_back(p);
  }
  return chosen;
}

double bound_by(const std::vector<Vec2>& witnesses, double radius, bool closed) {
  if (witnesses.size() < 2) return 0;
  std::vector<double> rings;
  for (std::size_t i = 0; i < witnesses.size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < witnesses.size(); ++k)
      if (k != i) nearest = std::min(nearest, distance(witnesses[i], witnesses[k]));
    rings.push_back(std::max(0.0, nearest / 2 - radius));
  }
  std::sort(rings.begin(), rings.end(), std::greater<>());
  double sum = 0;
  for (const double ring : rings) sum += 2 * ring;
  return closed ? sum : sum - rings[0] - std::max(rings[0], rings[1]);
}

}  // namespace

double covering_length_bound(const Regions& area, double radius, bool closed) {
  double bound = std::max(0.0, (geometry::area(area) - kPi * radius * radius) / (2 * radius));
  const std::vector<Vec2> places = boundary_places(area, radius);
  double apart = kNearest * radius;
  for (int i = 0; i < kDistances; ++i, apart *= kWider)
    bound = std::max(bound, bound_by(chosen_places(places, apart), radius, closed));
  return bound;
}

}  // namespace clearcut::plan::cover
