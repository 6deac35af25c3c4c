#include "features/derived_outlines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/elementary.h"
#include "base/tolerances.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::features {

Regions at_depth(const Regions& regions, Radians wall_slope, double below_top, const Tolerances& tol) {
  const double draft = below_top * base::tan(wall_slope.radians());
  if (draft <= 0) return regions;
  return inset(regions, draft, tol);
}

namespace {

/// mm. Arcs narrower than the cutter are replaced by chords this near to them.
constexpr double kChord = 0.0005;

/// mm. Until a cutter is chosen the kerf is taken to be this wide.
constexpr double kSomeKerf = 0.1;

/// `edge` moved to its left by d mm.
Edge beside(const Edge& edge, double d) {
  Edge out = edge;
  out.from = edge.from + left_of(edge.tangent_at(0)) * d;
  out.to = edge.to + left_of(edge.tangent_at(1)) * d;
  return out;
}

/// Outline of all points within r mm of an edge; arcs must have a greater radius.
Loop capsule(const Edge& edge, double r) {
  const Edge right = beside(edge, -r), left = beside(edge, r).reversed();
  const Vec2 ahead = edge.to + edge.tangent_at(1) * r, behind = edge.from - edge.tangent_at(0) * r;
  const auto quarter = [](Vec2 from, Vec2 to, Vec2 center) {
    return Edge::arc(from, to, center, Turn::kCounterClockwise);
  };
  return {right, quarter(right.to, ahead, edge.to),   quarter(ahead, left.from, edge.to),
          left,  quarter(left.to, behind, edge.from), quarter(behind, right.from, edge.from)};
}

std::vector<Loop> capsules(const Path& line, double r) {
  std::vector<Loop> loops;
  for (const Edge& edge : line) {
    if (!edge.is_arc() || edge.radius() > 1.01 * r) {
      // Pieces of less than half a turn, so that a capsule does not cross itself.
      const int pieces = edge.is_arc() ? 1 + static_cast<int>(std::abs(edge.sweep()) / 2) : 1;
      for (int i = 0; i < pieces; ++i) {
        loops.push_back(
            capsule(pieces == 1 ? edge : edge.part(static_cast<double>(i) / pieces, (i + 1.0) / pieces), r));
      }
      continue;
    }
    const double step = std::sqrt(8 * kChord * edge.radius());
    const int pieces = 1 + static_cast<int>(edge.length() / step);
    for (int i = 0; i < pieces; ++i) {
      const Vec2 a = edge.at(static_cast<double>(i) / pieces), b = edge.at((i + 1.0) / pieces);
      if (a != b) loops.push_back(capsule(Edge::line(a, b), r));
    }
  }
  return loops;
}

/// z of the material's underside: that of the stock; if no stock is stated, the lowest floor of the profiles on one
/// side of their outline, since those go through; else the lowest floor of all.
double underside_of(const Part& part) {
  if (part.stock) return part.stock->z_bottom;
  double of_profiles = part.top_z(), of_all = of_profiles;
  for (const Feature& feature : part.features) {
    const double floor = feature.floor_z + (feature.profile ? feature.profile->beyond : 0);
    of_all = std::min(of_all, floor);
    if (feature.profile && feature.profile->side != ProfileSide::kOn)
      of_profiles = std::min(of_profiles, floor);
  }
  return of_profiles < part.top_z() ? of_profiles : of_all;
}

}  // namespace

Regions kerf_of(const ProfileCut& cut, double width, const Tolerances& tol) {
  if (cut.side == ProfileSide::kOn) return resolve_nonzero(capsules(cut.line, width / 2), tol);
  const Regions within{Region::from_valid_loops(cut.line, {})};
  if (cut.side == ProfileSide::kOutside) return subtract(dilate(within, width, tol), within, tol);
  const Regions rest = inset(within.front(), width, tol);
  return rest.empty() ? within : subtract(within, rest, tol);
}

std::set<int> profiles_through(const Part& part) {
  const double underside = underside_of(part);
  std::set<int> through;
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    const Feature& feature = part.features[i];
    if (!feature.profile) continue;
    const bool follows = feature.profile->side == ProfileSide::kOn;
    if (!follows || feature.floor_z + feature.profile->beyond <= underside + kSamePlaceMm)
      through.insert(static_cast<int>(i));
  }
  return through;
}

bool may_free(const Feature& feature, const Part& part) {
  if (!feature.profile) return false;
  if (feature.profile->side != ProfileSide::kOn) return true;
  return feature.profile->closed && part.stock && feature.floor_z <= part.stock->z_bottom + kSamePlaceMm;
}

void follow(Feature& feature, ProfileCut cut, const Tolerances& tol) {
  feature.target = kerf_of(cut, kSomeKerf, tol);
  feature.allowed = feature.target;
  feature.profile = std::move(cut);
}

}  // namespace clearcut::features
