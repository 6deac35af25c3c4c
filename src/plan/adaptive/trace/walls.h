// The boundaries of an area for the cutter's centre ("walls": there the cutter touches the part), and the stretches of them
// along which the cutter would still touch material.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "geometry/region.h"
#include "plan/adaptive/remaining_stock.h"

namespace clearcut::plan::adaptive {

/// A closed loop on which places are given by s: mm along it from its beginning, in its direction. s may be negative or more
/// than the length: it goes round again.
class Wall {
 public:
  explicit Wall(Loop loop);

  double length() const { return ends_.back(); }
  Vec2 at(double s) const;
  Vec2 heading(double s) const;
  /// mm along the wall to the end of the edge that holds s; > s.
  double edge_end(double s) const;
  /// The part from s0 to s1, with s0 < s1 and less than once round.
  Path part(double s0, double s1) const;
  /// The place nearest to a point: s, and the distance in mm.
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

/// A place on one of several walls: s is mm along it.
struct WallPlace {
  std::size_t wall = 0;
  double s = 0;
  friend bool operator==(const WallPlace&, const WallPlace&) = default;
};

/// All walls of an area, with marks at a fixed pitch that say whether a cutter on them still touches material.
class Walls {
 public:
  /// The walls of `front` with a mark every `pitch` mm or less. Material thinner than `residual` mm does not count; where
  /// `front` keeps off the walls of `legal`, to which a wall pass is cut later, somewhat thicker material does not, either.
  Walls(const Region& front, const Region& legal, double pitch, double residual);
  /// All walls of `legal`; material of up to `residual` mm stays.
  Walls(const Region& legal, double pitch, double residual) : Walls(legal, legal, pitch, residual) {}

  const Wall& wall(std::size_t i) const { return walls_[i]; }
  /// Sets the stops (corners that are cut by a step of their own): a cut ends on the wall before a stop, and none begins
  /// before a stop and ends after it.
  void set_stops(std::vector<WallPlace> stops) { stops_ = std::move(stops); }
  /// mm along the wall to the next stop, and from the last one.
  double to_stop(const WallPlace& place) const { return to_nearest(stops_, place, 1); }
  double from_stop(const WallPlace& place) const { return to_nearest(stops_, place, -1); }
  Vec2 point(const WallPlace& place) const { return walls_[place.wall].at(place.s); }
  std::size_t count() const { return walls_.size(); }
  /// mm. How thick a residual may stay at a place.
  double residual(const WallPlace& place) const;
  /// Whether a mark on the next `reach` mm touches material.
  bool touches_after(const WallPlace& place, double reach) const;
  /// The nearest place on all walls.
  WallPlace nearest(Vec2 p) const;
  /// Asks the remaining stock again about the marks within `where` that were not clear.
  void update(const RemainingStock& remaining, const Box& where);
  /// The starts: the last clear mark before each stretch that touches material.
  std::vector<WallPlace> starts() const;
  /// One place on each wall that touches material all along and so has no start.
  std::vector<WallPlace> anywhere() const;
  /// Whether a place that starts() gave earlier still is a start.
  bool is_start(const WallPlace& place) const;
  /// Notes that a cut from a start left the wall at s while the start stays one. True if that is more than `least` mm farther
  /// than earlier cuts from that start got.
  bool advances(const WallPlace& start, double s, double least);
  /// Marks up to `count` marks after a start as given up: nothing can be cut from there now.
  void give_up(const WallPlace& place, int count = 1);
  /// A stretch of wall about a place, from `before` mm before it to `after` mm after it, that is left to a later step.
  struct Around {
    WallPlace place;
    double before = 0;
    double after = 0;
  };
  void leave_out(const Around& around);
  /// Allows a wedge to stay from a place to the end of its edge: `residual` mm thick at the place and nothing at the end, and
  /// kWedge mm more everywhere.
  void leave_wedge(const WallPlace& place, double residual);
  static constexpr double kWedge = 5e-4;
  /// Whether no other one of `places` is nearer than `least` mm along the wall.
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

/// The stretches of the walls along which material still stands, each ready to be run along. The walls are sampled every
/// `pitch` mm; stretches nearer to each other than `gap` mm are one.
std::vector<WallStretch> unfinished_walls(const Walls& walls, double pitch, double gap,
                                          const RemainingStock& remaining);

/// The part of a stretch along which material thicker than `residual` mm stands, sampled every `pitch` mm and in corners: from
/// just before the first such place to just after the last; none where nothing stands. Cost O(length / pitch) queries.
std::optional<WallStretch> bearing_part(const Walls& walls, const WallStretch& stretch, double pitch,
                                        double residual, const RemainingStock& remaining);

}  // namespace clearcut::plan::adaptive
