#include "plan/common/machine_clock.h"

#include <algorithm>
#include <vector>

#include "kinematics/kinematics.h"
#include "kinematics/planner.h"

namespace clearcut::plan {
namespace {

/// mm above the material at which the plunge begins.
constexpr double kAboveMaterial = 1;
constexpr double kPlungeShare = 0.3;  // the plunge feed as a share of the cutting feed

}  // namespace

RetractHeights retract_heights(const Layer& layer) {
  return {layer.lift, std::min(layer.lift, layer.z_top - layer.z + kAboveMaterial)};
}

double RetractLink::rapid_time(double length) const {
  return kinematics::travel_time(length, machine_.rapid.mm_per_s(), machine_.acceleration);
}

double RetractLink::time(double across) const {
  const auto [lift, plunge] = heights_;
  return rapid_time(lift) + rapid_time(lift - plunge) + rapid_time(across) +
         plunge / (kPlungeShare * feed_.mm_per_s());
}

double RetractLink::time_of(std::span<const Path> paths, double across) const {
  double time = 0;
  for (const auto& path : paths) {
    std::vector<Move> moves;
    for (const auto& edge : path) moves.push_back({edge, 0, 0, MoveKind::kCut, feed_, 0});
    time += kinematics::kinematic_time(moves, machine_).seconds() + RetractLink::time(across);
  }
  return time;
}

std::optional<Path> RetractLink::link_at_depth(Vec2 a, Vec2 b, const LegalRoutes& routes) const {
  const double lift = time(distance(a, b)), speed = feed_.mm_per_s();
  if (distance(a, b) / speed > lift) return std::nullopt;
  auto path = routes.between(a, b);
  if (!path || length(*path) / speed > lift) return std::nullopt;
  return path;
}

double MachineClock::seconds(std::span<const Edge> edges, std::span<const MoveKind> kinds) const {
  std::vector<Move> moves;
  moves.reserve(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const MoveKind kind = kinds.empty() ? MoveKind::kCut : kinds[i];
    if (edges[i].from != edges[i].to)
      moves.push_back({edges[i], 0, 0, kind, kind == MoveKind::kLink ? link_feed : feed, 0});
  }
  return kinematics::planned_time(moves, path, machine, of_control).seconds();
}

double MachineClock::radius_at(double speed) const {
  return speed * speed / (kAcrossArcs * machine.acceleration);
}

double MachineClock::run_up() const {
  const double speed = feed.mm_per_s();
  return speed * speed / (2 * machine.acceleration);
}

}  // namespace clearcut::plan
