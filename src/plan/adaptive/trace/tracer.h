// Traces single cuts: the curve on which the cutter's centre runs with the engagement at its limit.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "plan/adaptive/trace/arc_aimer.h"
#include "plan/adaptive/trace/wall_arcs.h"
#include "plan/adaptive/trace/walls.h"

namespace clearcut::plan::adaptive {

/// When a cut along a wall ends.
struct AlongWalls {
  double air = 0;      ///< mm of wall without engagement after which the cut ends
  double overrun = 0;  ///< mm by which it goes past the last place where it cut anything
};

/// Traces cuts with the material on the right of the direction of travel.
class Tracer {
 public:
  /// `limit`: largest engagement, radians. Off the walls the centre stays inside `area`. Traced cuts are
  /// removed from `remaining` at once. All arguments but numbers are kept by reference.
  Tracer(RemainingStock& remaining, const Walls& walls, const Regions& area, double limit, AlongWalls along);

  /// One cut that begins on a wall. It follows the wall until the engagement would exceed the limit, leaves
  /// it on an arc, and goes on with the engagement at the limit until it meets a wall or runs into the open.
  /// Empty if nothing can be cut from there. `material_s`: mm along the wall to where the material begins. If
  /// only a residual that may stay touches the wall before the arc, and `can_begin` is true for a point
  /// beside the wall, the cut begins at that point instead.
  using CanBegin = std::function<bool(Vec2)>;
  Path cut_from(const WallPlace& start, double material_s, const CanBegin& can_begin = {});
  /// One cut that begins off the walls at `from`; `heading` is a unit vector; `curvature`, 1 / mm and
  /// positive to the left, is tried first.
  Path cut_on(Vec2 from, Vec2 heading, double curvature);

  /// mm along the wall at which the last cut left it for the first time.
  double first_departure() const { return first_departure_; }

 private:
  enum class Next { kDone, kTrace, kWall };
  /// How many moves and cuts had been made at some moment, to return to that state.
  struct Mark {
    std::size_t moves = 0, cuts = 0;
  };
  /// The arcs between the wall that the cut follows and others.
  WallArcs arcs() const { return {remaining_, walls_, aimer_, limit_, place_, material_s_}; }

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
  bool begin_beside(const DepartureArc& off);
  Next on_from(const DepartureArc& off);
  void follow_from(const WallPlace& place);
  bool append_wall(double s_from, double s_to);
  bool append_as_one(std::span<const Edge> part, double s_from);

  Next trace();
  Next meet_wall(const CandidateArc& candidate, double inside);
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
  double engaged_ = 0;  ///< mm of this cut on which the cutter cut anything
  double air_ = 0;      ///< mm since the cutter last cut anything
  CutterState state_;
  WallPlace place_;
  double material_s_ = 0;
  CanBegin can_begin_;
  Mark before_wall_;  ///< the state before the cut met the wall that it follows now
  double first_departure_ = 0;
  /// The sample at which the last rejected departure arc exceeded the limit: checked first.
  int critical_sample_ = 0;
};

}  // namespace clearcut::plan::adaptive
