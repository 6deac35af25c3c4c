// Witness points of an area, each with the number of moves clearing it: they decide whether a path may be changed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "geometry/region.h"

namespace clearcut::plan::cover {

/// The parts of horizontal lines cleared by a disc moving along a move.
class ClearedBand {
 public:
  /// First and last x; empty if first > last.
  struct Run {
    double first = 1;
    double last = -1;
  };
  ClearedBand(Vec2 a, Vec2 b, double radius);
  Run at(double y) const;

 private:
  Vec2 a_, b_;
  double radius_;
  bool level_ = true, upright_ = true;  ///< along x (or a single point), along y
  double slope_ = 0, half_ = 0;         ///< band beside the move: dx for each dy, half its width along x
  double back_ = 0, along_ = 0;         ///< band across the move
  bool is_point_ = false;
};

/// Witness points: a square raster of the area, points along its boundary, and added points.
///
/// A point is cleared by a move if it is within `radius` of the move. Moves count equally in both directions, so that
/// removing a move reverts its addition exactly.
class Witnesses {
 public:
  /// `pitch`: mm between the points of the raster, and at most between points along the boundary.
  Witnesses(const Regions& area, double radius, double pitch);

  double radius() const { return radius_; }
  void add(Vec2 a, Vec2 b);
  /// Appends to `bare` the points no longer cleared by any move.
  void remove(Vec2 a, Vec2 b, std::vector<Vec2>& bare);
  void remove(Vec2 a, Vec2 b);
  /// Appends the points cleared only by the moves from a to p and from p to b; `a` or `b` may be absent.
  void only_cleared_by(const Vec2* a, Vec2 p, const Vec2* b, std::vector<Vec2>& points);
  /// One more point, cleared by `moves` moves so far.
  void add_point(Vec2 p, int moves);
  /// All uncleared points.
  std::vector<Vec2> bare() const;
  /// Rows of points visited so far: the measure of work.
  std::uint64_t work() const { return work_; }

 private:
  struct Point {
    Vec2 at;  ///< in the raster's frame
    int moves = 0;
  };
  struct Bucket {
    std::vector<Point> points;
  };
  /// Columns from `first` to `last` of a row; empty if first > last.
  struct Columns {
    std::ptrdiff_t first = 0, last = -1;
  };
  std::ptrdiff_t row_from(double y) const;
  std::ptrdiff_t row_to(double y) const;
  Columns columns_of(const ClearedBand& band, std::ptrdiff_t row);
  Vec2 raster_point(std::ptrdiff_t column, std::ptrdiff_t row) const {
    return turned_back(
        {corner_.x + static_cast<double>(column) * pitch_, corner_.y + static_cast<double>(row) * pitch_});
  }
  void append(std::ptrdiff_t row, Columns columns, std::uint8_t moves, std::vector<Vec2>& points) const;
  template <typename F>
  void for_rows(Vec2 a, Vec2 b, const F& f);
  template <typename F>
  void for_points(Vec2 a, Vec2 b, const F& f);
  Vec2 turned(Vec2 p) const { return {cosine_ * p.x - sine_ * p.y, sine_ * p.x + cosine_ * p.y}; }
  Vec2 turned_back(Vec2 p) const { return {cosine_ * p.x + sine_ * p.y, cosine_ * p.y - sine_ * p.x}; }
  std::size_t bucket_of(Vec2 p) const;
  void mark_inside(const std::vector<std::vector<Vec2>>& outlines);

  double cosine_,
      /// Direction of the raster against x: rows parallel to walls would miss material left between parallel moves.
      sine_;
  double radius_;
  double pitch_;
  Vec2 corner_;
  std::ptrdiff_t columns_ = 0, rows_ = 0;
  /// Number of moves for each raster point; kOutside for points outside the area.
  std::vector<std::uint8_t> moves_;
  double bucket_size_;
  std::ptrdiff_t bucket_columns_ = 0, bucket_rows_ = 0;
  std::vector<Bucket> buckets_;
  std::uint64_t work_ = 0;
};

}  // namespace clearcut::plan::cover
