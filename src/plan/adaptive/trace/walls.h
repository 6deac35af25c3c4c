// The walls of a layer as paths for the cutter's centre, and which stretches of them still touch material.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "geometry/region.h"
#include "plan/adaptive/remaining_stock.h"

namespace clearcut::plan::adaptive {

/// A closed loop walked by length.
class Wall {
 public:
  explicit Wall(Loop loop);

  double length() const { return ends_.back(); }
  Vec2 at(double s) const;
  Vec2 heading(double s) const;
  /// Where the edge that holds s ends, > s.
  double edge_end(double s) const;
  /// The edges between s0 < s1 (s1 - s0 below the loop's length).
  Path part(double s0, double s1) const;
  /// Nearest place: its length and distance.
  struct Hit {
    double s = 0;
    double distance = 0;
  };
  Hit nearest(Vec2 p) const;
  const Loop& loop() const { return loop_; }
  /// The middle of the longest edge: far from corners.
  double plainest() const;

 private:
  struct Spot {
    std::size_t edge = 0;
    double t = 0;
    double lap = 0;  ///< length of the whole turns before
  };
  Spot spot(double s) const;

  Loop loop_;
  std::vector<double> ends_;  ///< length at the end of each edge
};

/// A place on a wall.
struct WallPlace {
  std::size_t wall = 0;
  double s = 0;
  friend bool operator==(const WallPlace&, const WallPlace&) = default;
};

/// All walls with marks where a cutter on them would still touch material.
class Walls {
 public:
  /// The walls of `front` with a mark every `pitch` mm or less. Material thinner than `residual` mm does not
  /// count, nor some more where the walls of `legal` are farther off: there a wall pass follows.
  Walls(const Region& front, const Region& legal, double pitch, double residual);
  /// All walls of `legal`; material of up to `residual` mm stays.
  Walls(const Region& legal, double pitch, double residual) : Walls(legal, legal, pitch, residual) {}

  const Wall& wall(std::size_t i) const { return walls_[i]; }
  /// Cuts end on the wall before these places instead of leaving it there, and none begins before and ends after one.
  void set_stops(std::vector<WallPlace> stops) { stops_ = std::move(stops); }
  /// mm along the wall to the next stop, and from the last one.
  double to_stop(const WallPlace& place) const { return to_nearest(stops_, place, 1); }
  double from_stop(const WallPlace& place) const { return to_nearest(stops_, place, -1); }
  Vec2 point(const WallPlace& place) const { return walls_[place.wall].at(place.s); }
  std::size_t count() const { return walls_.size(); }
  double residual(const WallPlace& place) const;
  /// Whether a mark on the next `reach` mm touches material.
  bool touches_after(const WallPlace& place, double reach) const;
  /// The nearest place on all walls.
  WallPlace nearest(Vec2 p) const;
  /// Samples again at the marks within `where`.
  void update(const RemainingStock& remaining, const Box& where);
  /// The last clear mark before each stretch that touches material.
  std::vector<WallPlace> starts() const;
  /// A place on each wall that touches material all along.
  std::vector<WallPlace> anywhere() const;
  /// Whether the place, one of starts() before, still is one.
  bool is_start(const WallPlace& place) const;
  /// Notes that a cut left the wall at s and its start as it was; whether that is more than `least` mm farther than those
  /// before from there.
  bool advances(const WallPlace& start, double s, double least);
  /// Gives up to `count` marks after a start up: nothing more can be cut from there.
  void give_up(const WallPlace& place, int count = 1);
  /// Leaves what is within so many mm along the wall before and after a place to a later stage.
  struct Around {
    WallPlace place;
    double before = 0;
    double after = 0;
  };
  void leave_out(const Around& around);
  /// Up to the end of the edge that begins at a place a wedge may stay that is `residual` mm thick at the place, and kWedge more.
  void leave_wedge(const WallPlace& place, double residual);
  static constexpr double kWedge = 5e-4;  // mm
  /// Whether no other of `places` is nearer along the wall than `least` mm.
  bool is_alone(const WallPlace& place, const std::vector<WallPlace>& places, double least) const;

 private:
  /// mm along the wall to the nearest of `others`, not less than `least`. `sense`: 1 along the wall, -1 back.
  double to_nearest(const std::vector<WallPlace>& others, const WallPlace& place, double sense,
                    double least = 0) const;
  struct Marks {
    double pitch = 1;
    std::vector<Vec2> points;
    std::vector<double> residuals;
    std::vector<char> touching;
    std::vector<std::optional<Vec2>> touched;  ///< material that each mark touched when it was looked at
    std::vector<double> left_at;               ///< where the last cut from each mark left the wall
  };
  void add(const Loop& loop, const Region& legal, double pitch, double residual);
  std::size_t mark_at(const WallPlace& place) const;

  std::vector<Wall> walls_;
  std::vector<Marks> marks_;
  std::vector<WallPlace> stops_;
};

/// A stretch of a wall, from < to.
struct WallStretch {
  std::size_t wall = 0;
  double from = 0;
  double to = 0;
};

/// The stretches of the walls that still bear material, each ready to be run along. Stretches nearer to each other
/// than `gap` mm are one.
std::vector<WallStretch> unfinished_walls(const Walls& walls, double pitch, double gap,
                                          const RemainingStock& remaining);

/// What of a stretch bears material thicker than `residual` mm, looked at every `pitch` mm and in corners: from a place just
/// before the first to one just after the last; none where nothing does. Cost O(length / pitch) samples.
std::optional<WallStretch> bearing_part(const Walls& walls, const WallStretch& stretch, double pitch,
                                        double residual, const RemainingStock& remaining);

}  // namespace clearcut::plan::adaptive
