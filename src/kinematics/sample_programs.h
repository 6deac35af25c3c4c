// Small programs of the kinds found in plans, for tests of times.
#pragma once

#include <cstdint>
#include <vector>

#include "base/elementary.h"
#include "model/move.h"

namespace clearcut::kinematics::sample {

/// Draws moves one after the other.
class Pen {
 public:
  void rapid(Vec2 to, double z) { add(Edge::line(at_, to), z, MoveKind::kRapid, 0); }
  void line(Vec2 to, double feed) { add(Edge::line(at_, to), z_, MoveKind::kCut, feed); }
  void line(Vec2 to, double z, double feed) { add(Edge::line(at_, to), z, MoveKind::kCut, feed); }
  /// Turns by `degrees` about `center`, > 0 counter-clockwise.
  void arc(Vec2 center, double degrees, double feed) { arc(center, degrees, z_, feed); }
  void arc(Vec2 center, double degrees, double z, double feed) {
    const double angle = degrees * kPi / 180, c = base::cos(angle), s = base::sin(angle);
    const Vec2 from = at_ - center, to{from.x * c - from.y * s, from.x * s + from.y * c};
    add(Edge::arc(at_, center + to, center, angle > 0 ? Turn::kCounterClockwise : Turn::kClockwise), z,
        MoveKind::kCut, feed);
  }
  /// An arc of radius `r` starting in direction `heading` (degrees), to the left if `degrees` > 0.
  void bend(double heading, double r, double degrees, double feed) {
    const double h = heading * kPi / 180;
    const Vec2 left{-base::sin(h), base::cos(h)};
    arc(at_ + left * (degrees > 0 ? r : -r), degrees, feed);
  }
  Vec2 at() const { return at_; }
  std::vector<Move> take() { return std::move(moves_); }

 private:
  void add(const Edge& path, double z, MoveKind kind, double feed) {
    moves_.push_back({path, z_, z, kind, MmPerMin::of(feed), 0});
    at_ = path.to, z_ = z;
  }
  Vec2 at_;
  double z_ = 10;
  std::vector<Move> moves_;
};

/// 0 to 1, the same on every machine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed * 2654435761U + 12345) {}
  double roll() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state_ >> 11) / 9007199254740992.0;
  }
  double roll(double low, double high) { return low + (high - low) * roll(); }

 private:
  std::uint64_t state_;
};

inline Vec2 polar(double r, double degrees) {
  return {r * base::cos(degrees * kPi / 180), r * base::sin(degrees * kPi / 180)};
}

inline void go_down(Pen& pen, double feed) {
  pen.rapid(pen.at(), 1);
  pen.line(pen.at(), -2, feed * 0.3);
}

inline void go_up(Pen& pen) {
  pen.rapid(pen.at(), 10);
}

/// Squares of growing size in one path.
inline std::vector<Move> square_spiral(double feed) {
  Pen pen;
  go_down(pen, feed);
  const Vec2 heading[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (int i = 0; i < 24; ++i) pen.line(pen.at() + heading[i % 4] * (2.5 * (1 + i / 2)), feed);
  go_up(pen);
  return pen.take();
}

inline std::vector<Move> zigzag(double feed) {
  Pen pen;
  go_down(pen, feed);
  for (int i = 0; i < 12; ++i) {
    pen.line({i % 2 == 0 ? 40.0 + i : -i * 0.5, pen.at().y}, feed);
    pen.line(pen.at() + Vec2{i % 2 == 0 ? 1.5 : -1.0, 4}, feed);
  }
  go_up(pen);
  return pen.take();
}

/// Rings of many short lines with slight turns in both directions.
inline std::vector<Move> noisy_rings(double feed) {
  Pen pen;
  Dice dice(3);
  go_down(pen, feed);
  for (int ring = 1; ring <= 3; ++ring)
    for (int i = 0; i <= 60 * ring; ++i)
      pen.line(polar(8 * ring + dice.roll(-0.15, 0.15), 360.0 * i / (60 * ring)), feed);
  go_up(pen);
  return pen.take();
}

/// A circle of chords of a quarter of a millimetre.
inline std::vector<Move> chords(double feed) {
  Pen pen;
  pen.rapid({15, 0}, 10);
  go_down(pen, feed);
  for (int i = 1; i <= 370; ++i) pen.line(polar(15, 360.0 * i / 370), feed);
  go_up(pen);
  return pen.take();
}

/// Slots with round ends: smoothly joined lines and arcs.
inline std::vector<Move> round_slots(double feed) {
  Pen pen;
  go_down(pen, feed);
  for (double r : {2.0, 4.0, 7.0, 11.0, 16.0}) {
    const Vec2 at = pen.at();
    pen.line(at + Vec2{30, 0}, feed);
    pen.bend(0, r, 180, feed);
    pen.line(pen.at() - Vec2{30, 0}, feed);
    pen.bend(180, r, 180, feed);
    pen.line(at - Vec2{0, 3}, feed);
  }
  go_up(pen);
  return pen.take();
}

/// Arcs meeting at corners of all sizes, curved in the same or in opposite directions.
inline std::vector<Move> arcs_with_corners(double feed) {
  Pen pen;
  Dice dice(7);
  go_down(pen, feed);
  double heading = 0;
  for (int i = 0; i < 60; ++i) {
    const double sweep = dice.roll(15, 100) * (dice.roll() < 0.5 ? -1 : 1);
    pen.bend(heading, dice.roll(2, 20), sweep, feed);
    heading += sweep + dice.roll(-90, 90);
  }
  go_up(pen);
  return pen.take();
}

/// Moves of engagement-limited clearing: arcs into the material and fast lines back to their beginnings.
inline std::vector<Move> there_and_back(double feed) {
  Pen pen;
  pen.rapid({20, 0}, 10);
  go_down(pen, feed);
  for (int i = 0; i < 25; ++i) {
    const Vec2 begin = pen.at();
    pen.arc({0, 0}, 70, feed);
    pen.line(begin + Vec2{0.8, 0.3}, 2 * feed);
  }
  go_up(pen);
  return pen.take();
}

/// Helical entries with circles at their feet.
inline std::vector<Move> helices(double feed) {
  Pen pen;
  for (int i = 0; i < 4; ++i) {
    pen.rapid({20.0 * i + 3, 0}, 10);
    pen.rapid(pen.at(), 0.2);
    for (int k = 1; k <= 4; ++k) pen.arc({20.0 * i, 0}, 180, 0.2 - 0.5 * k, feed * 0.5);
    for (int k = 0; k < 2; ++k) pen.arc({20.0 * i, 0}, 180, feed);
    pen.line({20.0 * i + 8, 0}, feed);
    pen.arc({20.0 * i, 0}, 180, feed);
    pen.arc({20.0 * i, 0}, 180, feed);
    go_up(pen);
  }
  return pen.take();
}

inline std::vector<Move> drilled_holes(double feed) {
  Pen pen;
  for (int i = 0; i < 12; ++i) {
    pen.rapid({(i * 37) % 60 * 1.0, (i * 23) % 40 * 1.0}, 10);
    pen.rapid(pen.at(), 1);
    pen.line(pen.at(), -6, feed * 0.2);
    go_up(pen);
  }
  return pen.take();
}

/// Ramps to and fro, each a little lower.
inline std::vector<Move> ramps(double feed) {
  Pen pen;
  pen.rapid({0, 0}, 0.5);
  for (int i = 1; i <= 20; ++i)
    pen.line({i % 2 == 1 ? 15.0 : 0.0, i % 2 == 1 ? 6.0 : 0.0}, 0.5 - 0.15 * i, feed);
  go_up(pen);
  return pen.take();
}

/// Lines of all lengths and directions.
inline std::vector<Move> random_lines(double feed) {
  Pen pen;
  Dice dice(11);
  go_down(pen, feed);
  double heading = 0;
  for (int i = 0; i < 150; ++i) {
    heading += dice.roll(-1, 1) * dice.roll(0, 120);
    const double size = dice.roll();
    pen.line(pen.at() + polar(0.1 + 12 * size * size * size, heading), feed);
  }
  go_up(pen);
  return pen.take();
}

/// Lines and arcs joined only at small angles.
inline std::vector<Move> gentle_curve(double feed) {
  Pen pen;
  Dice dice(13);
  go_down(pen, feed);
  double heading = 0;
  for (int i = 0; i < 60; ++i) {
    heading += dice.roll(-4, 4);
    if (i % 3 == 0) {
      pen.line(pen.at() + polar(dice.roll(1, 10), heading), feed);
    } else {
      const double sweep = dice.roll(-60, 60);
      pen.bend(heading, dice.roll(3, 15), sweep, feed);
      heading += sweep;
    }
  }
  go_up(pen);
  return pen.take();
}

struct Program {
  const char* name;
  std::vector<Move> (*moves)(double feed);
};

inline constexpr Program kPrograms[] = {
    {"square_spiral", square_spiral},   {"zigzag", zigzag},
    {"noisy_rings", noisy_rings},       {"chords", chords},
    {"round_slots", round_slots},       {"arcs_with_corners", arcs_with_corners},
    {"there_and_back", there_and_back}, {"helices", helices},
    {"drilled_holes", drilled_holes},   {"ramps", ramps},
    {"random_lines", random_lines},     {"gentle_curve", gentle_curve}};

}  // namespace clearcut::kinematics::sample
