#include "kinematics/pieces.h"

#include <algorithm>

#include "base/elementary.h"

namespace clearcut::kinematics {
namespace {

/// Cosine; Grbl and Marlin take corners nearer to 0 or 180 degrees for straight on or for a reversal.
constexpr double kStraight = 0.999999;

Piece piece_of(const Leg& leg) {
  Piece piece;
  piece.index = leg.index;
  piece.length = leg.length;
  piece.first = leg.first;
  piece.last = leg.last;
  piece.top = leg.asked();
  piece.acceleration = leg.acceleration;
  if (leg.from_rest) piece.entry = 0;
  return piece;
}

void append_chords(const Leg& leg, std::size_t count, const AxisLimits& limits, std::vector<Piece>& out) {
  const Edge& arc = leg.move->path;
  const double turn = arc.sweep() / static_cast<double>(count);
  const double flat = 2 * arc.radius() * base::sin(std::abs(turn) / 2);
  const double rise = leg.climb() / static_cast<double>(count);
  Piece piece = piece_of(leg);
  piece.length = base::hypot(flat, rise);
  // From one chord to the next the direction turns by the same angle.
  const Vec2 tangent = arc.tangent_at(0);
  const double begin = base::atan2(tangent.y, tangent.x) + turn / 2;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = begin + turn * static_cast<double>(i);
    const double share = flat / piece.length;
    piece.first = piece.last = {base::cos(angle) * share, base::sin(angle) * share, rise / piece.length};
    piece.top = std::min(leg.programmed, most_along(piece.first, limits.speed));
    piece.acceleration = most_along(piece.first, limits.acceleration);
    out.push_back(piece);
    piece.entry = kNoLimit;
  }
}

}  // namespace

std::vector<Piece> whole_pieces(std::span<const Leg> legs) {
  std::vector<Piece> pieces;
  pieces.reserve(legs.size());
  for (const Leg& leg : legs) {
    Piece piece = piece_of(leg);
    if (leg.arc) {
      // The radius of curvature of a helix is r / cos^2 of its climb.
      const double climb = leg.climb() / leg.plan;
      piece.top =
          std::min(piece.top, std::sqrt(leg.acceleration * leg.move->path.radius() * (1 + climb * climb)));
    }
    pieces.push_back(piece);
  }
  return pieces;
}

std::vector<Piece> chord_pieces(std::span<const Leg> legs, const Machine& machine, ChordCount chords) {
  const AxisLimits limits = axis_limits(machine);
  std::vector<Piece> pieces;
  pieces.reserve(legs.size());
  for (const Leg& leg : legs) {
    if (leg.arc)
      append_chords(leg, std::max<std::size_t>(1, chords(leg, machine)), limits, pieces);
    else
      pieces.push_back(piece_of(leg));
  }
  return pieces;
}

double junction_speed(const Piece& before, const Piece& after, double acceleration, double deviation) {
  const double straight = dot(before.last, after.first);
  if (straight > kStraight) return kNoLimit;
  if (straight < -kStraight) return 0;
  const double s = std::sqrt((1 + straight) / 2);
  return std::sqrt(acceleration * deviation * s / (1 - s));
}

std::vector<double> planned_speeds(std::span<const Piece> pieces, std::size_t look_ahead) {
  const std::size_t count = pieces.size();
  std::vector<double> squares(count + 1, 0.0);
  for (std::size_t k = 1; k < count; ++k) {
    const double most = std::min({pieces[k].entry, pieces[k - 1].top, pieces[k].top});
    squares[k] = most * most;
  }
  double known = 0;  // mm; length of the pieces seen by the control from k on
  std::size_t end = count;
  for (std::size_t k = count; k-- > 0;) {
    const double a = pieces[k].acceleration;
    squares[k] = std::min(squares[k], squares[k + 1] + 2 * a * pieces[k].length);
    if (look_ahead == 0) continue;
    known += pieces[k].length;
    if (end - k > look_ahead) known -= pieces[--end].length;
    squares[k] = std::min(squares[k], 2 * a * std::max(known, pieces[k].length));
  }
  for (std::size_t k = 0; k < count; ++k)
    squares[k + 1] = std::min(squares[k + 1], squares[k] + 2 * pieces[k].acceleration * pieces[k].length);
  for (double& square : squares) square = std::sqrt(square);
  return squares;
}

void add_times(std::span<const Piece> pieces, std::span<const double> speeds, std::vector<Seconds>& times) {
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Piece& piece = pieces[k];
    Seconds& sum = times[piece.index];
    sum =
        sum + Seconds::of(ramped_time(piece.length, speeds[k], speeds[k + 1], piece.top, piece.acceleration));
  }
}

}  // namespace clearcut::kinematics
