// Traces single cuts: the curve on which the cutter's centre runs with the engagement at its limit.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "plan/adaptive/trace/arc_aimer.h"
#include "plan/adaptive/trace/walls.h"

namespace clearcut::plan::adaptive {

/// How cuts follow walls.
struct AlongWalls {
  double air = 0;      ///< mm of wall without engagement after which a cut ends
  double overrun = 0;  ///< mm that a cut runs on past the last place where it engaged
};

/// Traces cuts with the material on the right of the direction of travel.
class Tracer {
 public:
  /// `limit`: largest engagement in radians. Off the walls the centre stays inside `area`. What is traced is taken away from
  /// `remaining` at once. All is kept by reference.
  Tracer(RemainingStock& remaining, const Walls& walls, const Regions& area, double limit, AlongWalls along);

  /// One cut that begins on a wall: along the wall until the engagement would exceed the limit, off it on an arc, and on with
  /// the engagement at the limit until the cutter meets a wall ahead or runs into the open. Empty when nothing can be cut there
  /// within the limit. `material_s`: mm along the wall where the material begins that the cut is for. Where what stays on the
  /// wall is a residual that may stay, and `can_begin` accepts the place, the cut begins beside the wall with the arc that
  /// leads off it.
  using CanBegin = std::function<bool(Vec2)>;
  Path cut_from(const WallPlace& start, double material_s, const CanBegin& can_begin = {});
  /// One cut that begins off the walls, at `from` with a unit heading; `curvature` (1 / mm, > 0 to the left) is tried first.
  Path cut_on(Vec2 from, Vec2 heading, double curvature);

  /// mm along the wall where the last cut first left it.
  double first_departure() const { return first_departure_; }

 private:
  enum class Next { kDone, kTrace, kWall };
  /// How much was cut at some moment, to get back to it.
  struct Mark {
    std::size_t moves = 0, cuts = 0;
  };
  /// An arc off a wall at s (mm along it), from that state. It is of use if at least `least` mm of it can be cut. `met`: where
  /// it ends on a wall.
  struct DepartureArc {
    double s = 0;
    CutterState from;
    Edge arc;
    double least = 0;
    std::optional<WallPlace> met;
  };
  /// An arc that ends on a wall at a small angle; the cut goes on along the wall from there.
  struct Landing {
    Edge arc;
    WallPlace place;
  };

  Path run(Next next);
  Mark mark() const;
  void forget_beyond(const Mark& mark);

  Next follow_wall();
  double wall_engagement(double s) const;
  double end_of_cut(double cut_until) const;
  Next depart(double s_clear, double s_over);
  double last_within(double s_clear, double s_over) const;
  double latest_departure(double s_clear, double s_over, double radius, double least);
  bool can_leave(double s, double radius);
  Next leave(double s, double radius);
  CutterState state_at(double s, double radius, double kink) const;
  std::optional<DepartureArc> departure_arc(double s, double radius, double kink) const;
  std::optional<DepartureArc> crossing_arc(const DepartureArc& off) const;
  DepartureArc up_to_wall(double s, const CutterState& from, CandidateArc candidate) const;
  bool begin_beside(const DepartureArc& off);
  std::optional<Vec2> approach_point_before(double s, const Edge& arc) const;
  Next on_from(const DepartureArc& off);
  void follow_from(const WallPlace& place);
  bool append_wall(double s_from, double s_to);
  bool append_as_one(std::span<const Edge> part, double s_from);

  Next trace();
  Next meet_wall(const CandidateArc& candidate, double inside);
  std::optional<Landing> landing_of(const CutterState& from, const CandidateArc& candidate,
                                    double inside) const;
  bool leads_along(const WallPlace& met, Vec2 heading) const;
  bool step_to_wall(const WallPlace& place);

  bool is_within(const Edge& edge) const;
  double length_within(const Edge& edge) const;
  double go(const CandidateArc& candidate);
  void go(const Edge& edge, double within);
  bool append(const Edge& edge);
  void take(Edge edge);

  RemainingStock& remaining_;
  const Walls& walls_;
  ArcAimer aimer_;
  double radius_;
  double limit_;
  AlongWalls along_;
  double step_;
  Path path_;
  double engaged_ = 0;  ///< mm of the cut so far in which the cutter engaged
  double air_ = 0;      ///< mm since the cutter last engaged
  CutterState state_;
  WallPlace place_;
  double material_s_ = 0;
  CanBegin can_begin_;
  Mark before_wall_;  ///< as it was before the cut came to the wall that it follows
  double first_departure_ = 0;
  int critical_sample_ =
      0;  ///< sample at which the last rejected arc off the wall exceeded the limit: tried first
};

}  // namespace clearcut::plan::adaptive
