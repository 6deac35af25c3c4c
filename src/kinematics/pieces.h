// Straight pieces and arcs with a speed limit at each joint, as in all planners except LinuxCNC's.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "kinematics/leg.h"

namespace clearcut::kinematics {

/// A leg, or a chord of one.
struct Piece {
  std::size_t index = 0;  ///< index of the move
  double length = 0;      ///< mm
  Vec3 first, last;       ///< unit directions of travel at its ends
  double top = 0;         ///< mm/s
  double acceleration = 0;
  double entry = kNoLimit;  ///< mm/s; greatest speed at its start; 0: it starts from rest
};

/// One piece for each leg; on arcs v^2 <= a r.
std::vector<Piece> whole_pieces(std::span<const Leg> legs);

/// Number of chords of an arc.
using ChordCount = std::size_t (*)(const Leg& arc, const Machine& machine);
/// Lines as they are, arcs as chords with the limits of their directions.
std::vector<Piece> chord_pieces(std::span<const Leg> legs, const Machine& machine, ChordCount chords);

/// mm/s by junction deviation: v^2 = a d s / (1 - s), s = sin(theta / 2), theta the angle between the pieces (pi:
/// straight on). Nearly straight on there is no limit, nearly back there is a stop.
double junction_speed(const Piece& before, const Piece& after, double acceleration, double deviation);

/// Speeds at the start of each piece, and 0 after the last: the greatest ones allowed by entries, accelerations and,
/// if `look_ahead` is not 0, this number of known pieces.
std::vector<double> planned_speeds(std::span<const Piece> pieces, std::size_t look_ahead = 0);

/// Adds the time of each piece to the time of its move.
void add_times(std::span<const Piece> pieces, std::span<const double> speeds, std::vector<Seconds>& times);

}  // namespace clearcut::kinematics
