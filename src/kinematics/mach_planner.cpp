// Mach3 and Mach4. Rules: "Using Mach3Mill" (constant velocity and exact stop, settings of CV control): in exact stop
// every move ends at rest; in constant velocity a move begins when the previous one begins to slow down, so that both
// together keep the speed.
#include <algorithm>

#include "kinematics/families.h"
#include "kinematics/pieces.h"

namespace clearcut::kinematics {
namespace {

/// s; time in which a piece comes to rest from its reached speed.
double braking_time(const Piece& piece) {
  return std::min(piece.top, std::sqrt(piece.acceleration * piece.length)) / piece.acceleration;
}

bool runs_on(const Leg& leg) {
  return leg.path.mode != PathMode::kExactStop && leg.path.mode != PathMode::kExactPath;
}

}  // namespace

void plan_mach(std::span<const Leg> legs, const Machine&, std::vector<Seconds>& times) {
  std::vector<Piece> pieces = whole_pieces(legs);
  for (Piece& piece : pieces) piece.entry = 0;
  add_times(pieces, planned_speeds(pieces), times);
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    if (legs[k].from_rest || !runs_on(legs[k - 1])) continue;
    const double both = std::min(braking_time(pieces[k - 1]), braking_time(pieces[k]));
    Seconds& time = times[pieces[k - 1].index];
    time = Seconds::of(std::max(0.0, time.seconds() - both));
  }
}

}  // namespace clearcut::kinematics
