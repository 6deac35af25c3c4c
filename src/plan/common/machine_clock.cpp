#include "plan/common/machine_clock.h"

#include <vector>

#include "kinematics/planner.h"

namespace clearcut::plan {

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
