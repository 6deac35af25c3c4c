// The boundaries of an area for the cutter's centre, called walls because the cutter touches the part there,
// and the stretches of them from which the cutter still touches material.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "geometry/region.h"
#include "plan/adaptive/clearing/remaining_stock.h"

namespace clearcut::plan::adaptive {

/// A closed loop with a parameter s: mm along it from its beginning. Negative s, and s beyond the length, go
/// round again.
class Wall {
 public:
  explicit Wall(Loop loop);

  double length() const { return ends_.back(); }
  Vec2 at(double s) const;
  Vec2 heading(double s) const;
  /// mm along the wall to the end of the edge that holds s; always greater than s.
  double edge_end(double s) const;
  /// The part from s0 to s1; s0 < s1, less than once round.
  Path part(double s0, double s1) const;
  /// A place on the wall: its s, and its distance in mm from the point that was asked for.
  struct Hit {
    double s = 0;
    double distance = 0;
  };
  Hit nearest(Vec2 p) const;
  const Loop& loop() const { return loop_; }
  /// s of the middle of the longest edge: a place far from corners.
  double plainest() const;

 private:
  /// A parameter s as an edge and a parameter of that edge.
  struct Spot {
    std::size_t edge = 0;
    double t = 0;
    double lap = 0;  ///< mm; length of the whole rounds before
  };
  Spot spot(double s) const;

  Loop loop_;
  std::vector<double> ends_;  ///< mm along the wall to the end of each edge
};

/// A place on one of several walls; s as in Wall.
struct WallPlace {
  std::size_t wall = 0;
  double s = 0;
  friend bool operator==(const WallPlace&, const WallPlace&) = default;
};

/// All walls of an area, with marks at a fixed pitch. A mark knows whether a cutter standing there touches
/// material.
class Walls {
 public:
  /// The walls of `front`, with a mark every `pitch` mm or less. Material thinner than `residual` mm does not
  /// count as touched. Where `front` keeps a distance from the walls of `legal`, which a wall pass cuts
  /// later, somewhat more is left to that pass.
  Walls(const Region& front, const Region& legal, double pitch, double residual);
  /// The walls of `legal`, where material of up to `residual` mm may stay.
  Walls(const Region& legal, double pitch, double residual) : Walls(legal, legal, pitch, residual) {}

  const Wall& wall(std::size_t i) const { return walls_[i]; }
  /// Sets the stops, corners that are cut in a step of their own: cuts along walls end before a stop, and no
  /// cut begins before a stop and ends after it.
  void set_stops(std::vector<WallPlace> stops) { stops_ = std::move(stops); }
  /// mm along the wall from `place` to the next stop; and back from `place` to the last stop.
  double to_stop(const WallPlace& place) const { return to_nearest(stops_, place, 1); }
  double from_stop(const WallPlace& place) const { return to_nearest(stops_, place, -1); }
  Vec2 point(const WallPlace& place) const { return walls_[place.wall].at(place.s); }
  std::size_t count() const { return walls_.size(); }
  /// The greatest thickness of a residual that may stay at a place, mm.
  double residual(const WallPlace& place) const;
  /// Whether a mark within `reach` mm after `place` touches material.
  bool touches_after(const WallPlace& place, double reach) const;
  /// The nearest place on all walls.
  WallPlace nearest(Vec2 p) const;
  /// Recomputes the marks within `where` that were not clear.
  void update(const RemainingStock& remaining, const Box& where);
  /// The last clear mark before each stretch of wall that touches material.
  std::vector<WallPlace> starts() const;
  /// One place on each wall that touches material all along, and so has no start.
  std::vector<WallPlace> anywhere() const;
  /// Whether `place`, which starts() returned earlier, still is a start.
  bool is_start(const WallPlace& place) const;
  /// Records that a cut from `start` left the wall at s, while the start remains one. True if s is more than
  /// `least` mm beyond what earlier cuts from that start reached.
  bool advances(const WallPlace& start, double s, double least);
  /// Takes up to `count` marks after `place` out of use: nothing can be cut from there now.
  void give_up(const WallPlace& place, int count = 1);
  /// A stretch of wall about a place, from `before` mm before it to `after` mm after it.
  struct Around {
    WallPlace place;
    double before = 0;
    double after = 0;
  };
  /// Takes the marks of a stretch out of use, because a later step cuts it.
  void leave_out(const Around& around);
  /// Allows a wedge of residual between `place` and the end of its edge: `residual` mm thick at the place and
  /// zero at the end, plus kWedge mm.
  void leave_wedge(const WallPlace& place, double residual);
  static constexpr double kWedge = 5e-4;
  /// Whether all others of `places` are at least `least` mm away along the wall.
  bool is_alone(const WallPlace& place, const std::vector<WallPlace>& places, double least) const;

 private:
  /// mm along the wall from `place` to the nearest of `others` that is at least `least` away. `sense`: 1
  /// forwards, -1 backwards.
  double to_nearest(const std::vector<WallPlace>& others, const WallPlace& place, double sense,
                    double least = 0) const;
  /// The marks of one wall; a value for each mark.
  struct Marks {
    double pitch = 1;
    std::vector<Vec2> points;
    std::vector<double> residuals;
    std::vector<char> touching;
    std::vector<std::optional<Vec2>>
        touched;                  ///< a point of the material that it touched when it was last computed
    std::vector<double> left_at;  ///< mm along the wall: where the last cut from it left the wall
  };
  void add(const Loop& loop, const Region& legal, double pitch, double residual);
  std::size_t mark_at(const WallPlace& place) const;

  std::vector<Wall> walls_;
  std::vector<Marks> marks_;
  std::vector<WallPlace> stops_;
};

/// The part of a wall from `from` to `to`, mm along it; from < to.
struct WallStretch {
  std::size_t wall = 0;
  double from = 0;
  double to = 0;
};

/// The stretches of the walls along which material still stands, extended so that each can be cut along. The
/// walls are sampled every `pitch` mm; stretches less than `gap` mm apart are joined.
std::vector<WallStretch> unfinished_walls(const Walls& walls, double pitch, double gap,
                                          const RemainingStock& remaining);

/// The part of a stretch along which material thicker than `residual` mm stands: from just before the first
/// such sample to just after the last. Samples are `pitch` mm apart and at corners. Nothing if nothing
/// stands. Cost: O(length / pitch) queries.
std::optional<WallStretch> unfinished_part(const Walls& walls, const WallStretch& stretch, double pitch,
                                           double residual, const RemainingStock& remaining);

}  // namespace clearcut::plan::adaptive
