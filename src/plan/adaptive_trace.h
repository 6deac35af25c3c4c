// Cuts that keep the engagement at its limit: the curve that the cutter's centre has to run on for that.
#pragma once

#include <functional>
#include <optional>

#include "plan/adaptive_ground.h"
#include "plan/adaptive_walls.h"

namespace clearcut {

/// How cuts follow walls.
struct AlongWalls {
  double air = 0;      ///< mm without contact that end a cut
  double overrun = 0;  ///< mm past the last contact
};

/// Traces cuts with the material on the right of the direction of travel.
class Tracer {
 public:
  /// `limit`: largest contact, radians. Cuts off the walls stay inside `area`. The tracer takes away what it
  /// cuts from `ground`.
  Tracer(Ground& ground, const Walls& walls, const Regions& area, double limit, AlongWalls along);

  /// One cut from a place on a wall: along the wall until the contact would exceed the limit, off it on an
  /// arc, on with the contact at its limit, until the cutter meets a wall ahead or runs into the open.
  /// Empty when nothing can be cut there within the limit. What it is after begins at `material_s`.
  /// Where so little stays on the wall that it may, and `can_begin` agrees to the place, the cut begins beside the wall
  /// with the arc that leads off it.
  using CanBegin = std::function<bool(Vec2)>;
  Path cut_from(const WallPlace& start, double material_s, const CanBegin& can_begin = {});
  /// The same from where the cutter already cuts.
  Path cut_on(Vec2 from, Vec2 heading, double curvature);

  /// Where the last cut first left its wall.
  double first_departure() const { return first_departure_; }

 private:
  struct State {
    Vec2 point;
    Vec2 heading;
    double curvature = 0;  ///< 1 / mm, > 0 to the left
  };
  enum class Next { kDone, kTrace, kWall };

  /// An arc from the state on, by curvature and length.
  struct Shot {
    double curvature = 0;
    double length = 0;
    double kink = 0;  ///< radians to the left, before it
    bool meets_wall = false;
  };

  Path run(Next next);
  Next follow_wall();
  Next depart(double s_clear, double s_over);
  double latest_departure(double s_clear, double s_over, double radius, double least);
  bool can_leave(double s, double radius);
  double off_wall(double radius) const;
  bool leave(double s, double radius);
  std::optional<Shot> set_off(double s, double radius);
  double length_off(const Shot& shot) const;
  bool begin_beside(const Edge& off, double least);
  std::optional<Vec2> gate_before(const Edge& arc) const;
  bool leaves_wall(const Shot& shot) const;
  Next trace();
  Next meet_wall(const Shot& shot, double inside);
  State after(const Shot& shot, double length) const;
  Edge edge_of(const Shot& shot) const;
  double contact_after(const Shot& shot, double length) const;
  std::optional<Shot> shoot() const;
  std::optional<Shot> steady_shot(double length, double guess) const;
  std::optional<Shot> shoot_closely(double guess) const;
  std::optional<Shot> aim(double length, double guess, int looks) const;
  std::optional<Shot> bend(Shot shot) const;
  bool is_steady(const Shot& shot) const;
  double length_inside(const Shot& shot) const;
  double go(const Shot& shot);
  double go(const Shot& shot, double within);
  double wall_contact(double s) const;
  bool append(const Edge& edge);
  void take(Edge edge);
  bool append_wall(double s_from, double s_to);
  void drop_way_to_wall();

  Ground& ground_;
  const Walls& walls_;
  LegalArea area_;
  double radius_;
  double limit_;
  AlongWalls along_;
  double step_;
  Path path_;
  double engaged_ = 0;  ///< mm of the cut in contact
  double air_ = 0;      ///< mm since the last contact
  State state_;
  double contact_ = 0;    ///< at the state
  bool on_wall_ = false;  ///< the state
  double usual_ = 0;      ///< mm, length of the last arc
  WallPlace place_;
  double material_s_ = 0;
  CanBegin can_begin_;
  struct {
    std::size_t moves = 0, cuts = 0;
  } before_wall_;  ///< before the way to the wall that the cut met last
  double first_departure_ = 0;
  int critical_look_ = 0;  ///< where an arc off the wall exceeded the limit last
  double tightest_ = 1;    ///< mm, radius of the tightest turn allowed
};

}  // namespace clearcut
