#include "part/round_hole.h"

#include <algorithm>

namespace clearcut {

std::optional<RoundHole> round_hole_of(const Feature& feature, const Tolerances& tol) {
  if (!closed_all_round(feature) || feature.wall_slope.radians() != 0 || feature.target.size() != 1)
    return std::nullopt;
  const Region& region = feature.target.front();
  const Edge& first = region.outer().front();
  if (!region.islands().empty() || !first.is_arc()) return std::nullopt;
  RoundHole hole{first.center, first.radius()};
  for (const Edge& edge : region.outer()) {
    if (!edge.is_arc() || edge.turn != first.turn) return std::nullopt;
    if (distance(edge.center, first.center) > tol.join_gap) return std::nullopt;
    if (std::abs(edge.radius() - first.radius()) > tol.join_gap) return std::nullopt;
    hole.radius = std::min(hole.radius, edge.radius());
  }
  return hole;
}

bool only_plunges(const Tool& tool) {
  return tool.kind == ToolKind::kDrill || tool.kind == ToolKind::kReamer;
}

bool makes_hole(const Tool& tool, const RoundHole& hole, const Tolerances& tol) {
  const double spare = 2 * hole.radius - tool.diameter;
  return spare >= -tol.fit && spare <= tol.uncut;
}

}  // namespace clearcut
