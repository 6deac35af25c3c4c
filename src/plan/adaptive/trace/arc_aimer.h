// Arcs that keep the engagement at its limit: from where a cut is, the one that leads on.
#pragma once

#include <optional>

#include "plan/adaptive/remaining_stock.h"

namespace clearcut::plan::adaptive {

/// Radians by which arcs may exceed the limit.
inline constexpr double kAboveLimit = 0.025;
/// mm. Shorter moves are left out.
inline constexpr double kShortestMove = 1e-4;

/// Where a cut is, with the material on its right, and how it may go on.
struct Course {
  Vec2 point;
  Vec2 heading;
  double curvature = 0;            ///< 1 / mm, > 0 to the left
  double contact = 0;              ///< radians, before the last move was cut
  double usual = 0;                ///< mm, length of the last arc
  double tightest = 1;             ///< mm, radius of the tightest turn to the left
  std::optional<double> off_wall;  ///< on a wall: radians by which it heads off it
};

/// An arc from a course on, by curvature and length.
struct Shot {
  double curvature = 0;
  double length = 0;
  double kink = 0;  ///< radians to the left, before it
  bool meets_wall = false;
};

/// One arc up to a wall, below the limit where it has to be.
struct Crossing {
  Shot shot;
  double lost = 0;  ///< mm of a cut at the limit that would take what it leaves
  bool loses_little() const;
};

/// Where a shot is after `length` mm.
struct Heading {
  Vec2 point;
  Vec2 heading;
};
Heading after(const Course& from, const Shot& shot, double length);
/// The shot as a move; a line where it is flat.
Edge edge_of(const Course& from, const Shot& shot);
/// The arc to p that begins with the heading turned by `kink`; a line where that is flat.
Edge arc_to(const Course& from, double kink, Vec2 p);

/// Aims arcs.
class ArcAimer {
 public:
  /// `limit`: largest contact, radians. Arcs stay inside `area`. The ground is kept by reference.
  ArcAimer(const Ground& ground, const Regions& area, double limit);

  /// The longest arc that was found that keeps the contact at the limit, up to the wall ahead.
  std::optional<Shot> shoot(const Course& from) const;
  /// Where the contact cannot be kept up, or jumps: a short one, looked at closely.
  std::optional<Shot> shoot_closely(const Course& from, double guess) const;
  /// Instead of a shot, and the ones after it: a single arc up to the wall ahead, if little is lost by that.
  std::optional<Shot> to_wall(const Course& from, const Shot& shot) const;
  /// The flattest arc up to the wall ahead that keeps the limit all along. Looked for near a curvature of `guess` first.
  std::optional<Crossing> across(const Course& from, double guess) const;
  /// Such an arc, looked at closely; a little tighter where it has to be.
  std::optional<Shot> surely_within(const Course& from, Shot across) const;
  /// Whether an arc of that curvature meets a wall soon.
  bool meets_wall(const Course& from, double curvature) const;
  /// mm of the shot inside the area for cuts; of one that heads off a wall, the way off it counts as inside.
  double length_inside(const Course& from, const Shot& shot) const;
  /// Whether a shot from a wall on gets off it.
  bool leaves_wall(const Course& from, const Shot& shot) const;
  /// mm of such a shot up to where it is well inside the area for cuts; 0 where it never is.
  double length_off(const Course& from, const Shot& shot) const;
  /// Radians that an arc of `radius` along a wall turns by up to there.
  double turn_off(double radius) const;
  bool is_inside(Vec2 p) const { return area_.contains(p); }

 private:
  enum class Fit { kExceeds, kFits, kMissesWall };
  Fit cross(const Course& from, double curvature, Crossing& crossing) const;
  double contact_at(const Heading& at) const;
  double contact_after(const Course& from, const Shot& shot, double length) const;
  std::optional<Shot> steady_shot(const Course& from, double length, double guess) const;
  std::optional<Shot> aim(const Course& from, double length, double guess, int looks) const;
  std::optional<Shot> bend(const Course& from, Shot shot) const;
  bool is_steady(const Course& from, const Shot& shot) const;

  const Ground& ground_;
  LegalArea area_;
  double radius_;
  double limit_;
};

}  // namespace clearcut::plan::adaptive
